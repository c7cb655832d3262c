#include "sim/command_line.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <type_traits>
#include <utility>

namespace rc2 {
namespace {

template <typename Value>
bool is_empty(const Value& value) {
  return value.empty();
}
template <typename Value>
bool is_empty(const std::optional<Value>& value) {
  return !value;
}
bool is_empty(std::int64_t) { return false; }
bool is_empty(int) { return false; }
bool is_empty(double) { return false; }

}  // namespace

Option& Option::required() {
  option_->required()->default_str("");
  return *this;
}

Option& Option::type(const std::string& name) {
  option_->type_name(name);
  return *this;
}

Option& Option::one_of(std::vector<std::string> words) {
  option_->check(CLI::IsMember(std::move(words)));
  return *this;
}

Option& Option::one_of(std::initializer_list<int> numbers) {
  option_->check(CLI::IsMember(std::vector<int>(numbers)));
  return *this;
}

Option& Option::within(int lowest, int highest) {
  option_->check(CLI::Range(lowest, highest));
  return *this;
}

Option& Option::within(std::int64_t lowest, std::int64_t highest) {
  option_->check(CLI::Range(lowest, highest));
  return *this;
}

Option& Option::within(double lowest, double highest) {
  option_->check(CLI::Range(lowest, highest));
  return *this;
}

Option& Option::list() {
  option_->delimiter(',');
  return *this;
}

Option& Option::list_of(int length) {
  option_->delimiter(',')->expected(length);
  return *this;
}

Option& Option::repeated() {
  option_->allow_extra_args(false);
  return *this;
}

Option& Option::needs(const Option& other) {
  option_->needs(other.option_);
  return *this;
}

Option& Option::excludes(const Option& other) {
  option_->excludes(other.option_);
  return *this;
}

Command Command::command(const std::string& name, const std::string& help) {
  return {app_->add_subcommand(name, help), exit_code_};
}

template <typename Value>
Option Command::option(const std::string& name, Value& value, const std::string& help) {
  CLI::Option* option = app_->add_option(name, value, help);
  if (!is_empty(value)) option->capture_default_str();
  return Option(option);
}

template Option Command::option(const std::string&, int&, const std::string&);
template Option Command::option(const std::string&, std::int64_t&, const std::string&);
template Option Command::option(const std::string&, double&, const std::string&);
template Option Command::option(const std::string&, std::string&, const std::string&);
template Option Command::option(const std::string&, std::optional<int>&, const std::string&);
template Option Command::option(const std::string&, std::vector<int>&, const std::string&);
template Option Command::option(const std::string&, std::vector<std::int64_t>&, const std::string&);
template Option Command::option(const std::string&, std::vector<double>&, const std::string&);
template Option Command::option(const std::string&, std::vector<std::string>&, const std::string&);

Option Command::flag(const std::string& name, bool& value, const std::string& help) {
  return Option(app_->add_flag(name, value, help));
}

Command Command::choice(const std::string& name) {
  return {app_->add_option_group(name)->require_option(1), exit_code_};
}

void Command::run(std::function<ExitCode()> action) {
  app_->callback([to = exit_code_, action = std::move(action)] { *to = action(); });
}

}  // namespace rc2
