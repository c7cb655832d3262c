// The commands of a program and their options: CLI11, whose headers take longer to compile than
// most commands, behind one file that reads them.
#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "sim/exit_code.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace rc2 {

/// An option of a command. Words that it does not take are said to the user when they are read.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  Option& required();
  /// What --help calls the value.
  Option& type(const std::string& name);
  Option& one_of(std::vector<std::string> words);
  Option& one_of(std::initializer_list<int> numbers);
  Option& within(int lowest, int highest);
  Option& within(std::int64_t lowest, std::int64_t highest);
  Option& within(double lowest, double highest);
  /// A list between commas.
  Option& list();
  Option& list_of(int length);
  /// A list with the option before each value.
  Option& repeated();
  Option& needs(const Option& other);
  Option& excludes(const Option& other);

 private:
  CLI::Option* option_;
};

/// A program or one of its commands.
class Command {
 public:
  /// What is done sets `exit_code`.
  Command(CLI::App* app, ExitCode* exit_code) : app_(app), exit_code_(exit_code) {}

  Command command(const std::string& name, const std::string& help);
  /// Stored in `value`, whose default --help shows unless it is empty. A name without dashes has a
  /// place of its own. Of int, int64_t, double, string, vectors of these, and optional<int>.
  template <typename Value>
  Option option(const std::string& name, Value& value, const std::string& help);
  Option flag(const std::string& name, bool& value, const std::string& help);
  /// Of the options declared in it exactly one must be given.
  Command choice(const std::string& name);
  /// What is done when the words have been read.
  void run(std::function<ExitCode()> action);

 private:
  CLI::App* app_;
  ExitCode* exit_code_;
};

}  // namespace rc2
