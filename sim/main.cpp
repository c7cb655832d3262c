// rc2: the host of an RC2 machine, in silicon to be or in software.
#include "sim/program.h"

int main(int argc, char** argv) { return rc2::run_program(argc, argv); }
