// Options of a command, declared one line each: text after the option goes through a parser of parse_value.h.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace isolume {

/// Adds options to one group of a command's help.
class OptionGroup {
 public:
  OptionGroup(CLI::App& app, std::string name) : app_(app), name_(std::move(name)) {}

  /// `set(option, text)` is called with the long name of the option and the text that follows it.
  template <class Set>
  void value(const std::string& flags, const std::string& valueName, Set set, const std::string& description) {
    const std::string longName = flags.substr(flags.find("--"));
    app_.add_option_function<std::string>(
            flags, [longName, set](const std::string& text) { set(longName, text); }, description)
        ->type_name(valueName)
        ->group(name_);
  }
  void flag(const std::string& flags, bool& target, const std::string& description) {
    app_.add_flag(flags, target, description)->group(name_);
  }

 private:
  CLI::App& app_;
  std::string name_;
};

}  // namespace isolume
