// Any command line made of the program's own words and of values that options may or may not take.
// Whatever comes, the program ends, says at most that the input is bad, and then leaves no file
// behind. Sizes are kept small: this looks for wrong answers, not for long ones.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "sim/program.h"
#include "tb/fuzz/bytes.h"

namespace rc2::tb {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kValues = {
    "4",     "8",      "2",      "1",          "0",        "-1",         "3",
    "5..4",  "1,2",    "2,2,2",  "0.5",        "1e9",      "nan",        "",
    "x",     "empty",  "ball:2", "room",       "dust:1:1", "shells:5:1", "ball:",
    "a.csv", "b.csv",  "out",    "none/x.csv", "golden",   "cycle",      "rtl",
    "fast",  "thesis", "on",     "off",        "armoured", "naive",      "accurate",
    "all",   "sphere", "boxes",  "--",         "-1,0,3",   "4,8",        "9999999999999999999999",
    "é",     "2.5",    "fa1",    "gallery"};

// Where the program runs: a folder of its own, which goes with the process.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "rc2-fuzz-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
    fs::current_path(path_);
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

const fs::path& here() {
  static const Folder folder;
  return folder.path();
}

std::set<std::string> files() {
  std::set<std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(here())) found.insert(entry.path());
  return found;
}

// Commands that take long, however little they are asked for.
bool is_long(const std::string& command) {
  return command == "thesis" || command == "network" || command == "leaks" ||
         command == "load-speed" || command == "tunnels";
}

// What makes a small job of a few words: a size and, unless it is left out to see what happens,
// what is required.
void complete(const std::vector<const CLI::Option*>& options, bool with_required,
              std::vector<std::string>& words) {
  const auto named = [&](const std::string& word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  for (const CLI::Option* option : options) {
    const bool is_place = option->get_lnames().empty();
    const std::string name = is_place ? "" : "--" + option->get_lnames().front();
    const bool wants = with_required && option->get_required();
    if (is_place && wants) words.insert(words.begin() + 2, "ball:2");
    if (is_place || named(name)) continue;
    if (name == "--n") words.insert(words.end(), {name, "8"});
    if (wants) words.insert(words.end(), {name, "a.csv"});
  }
}

std::vector<std::string> make_words(Bytes& bytes) {
  CLI::App program;
  ExitCode unused = kDone;
  declare_all(program, unused);
  const auto commands = program.get_subcommands([](const CLI::App*) { return true; });
  const CLI::App* command = commands[bytes.below(commands.size())];
  std::vector<std::string> words{"rc2", command->get_name()};
  if (is_long(command->get_name())) words.emplace_back("--help");
  const std::vector<const CLI::Option*> options = command->get_options();
  const bool is_complete = bytes.below(8) != 0;
  for (std::size_t left = bytes.below(8); left > 0 && !bytes.empty(); --left) {
    const CLI::Option* option = options[bytes.below(options.size())];
    const std::string& value = kValues[bytes.below(kValues.size())];
    const std::size_t choice = bytes.below(8);
    if (choice != 0 && !option->get_lnames().empty())
      words.push_back("--" + option->get_lnames().front());
    if (choice != 1) words.push_back(value);
  }
  complete(options, is_complete, words);
  return words;
}

}  // namespace
}  // namespace rc2::tb

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace rc2;
  tb::Bytes bytes(data, size);
  const auto before = tb::files();
  const std::vector<std::string> words = tb::make_words(bytes);
  std::vector<const char*> argv;
  argv.reserve(words.size());
  for (const std::string& word : words) argv.push_back(word.c_str());
  // Said before, because who hangs says nothing after.
  std::string line;
  for (const std::string& word : words) line += " '" + word + "'";
  std::cerr << line << '\n';
  const ExitCode code = run_program(static_cast<int>(argv.size()), argv.data());
  if (code == kBroken) throw std::logic_error("internal error of" + line);
  if (code == kBadInput && tb::files() != before) throw std::logic_error("half a result of" + line);
  for (const auto& entry : std::filesystem::directory_iterator(tb::here()))
    remove_all(entry.path());
  return 0;
}
