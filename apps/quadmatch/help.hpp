#pragma once
/// Help that fits a terminal: names to the left, wrapped sentences to the right, defaults at their end.

#include <string>

#include <CLI/CLI.hpp>

namespace quadmatch::cli {

class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option(const CLI::Option* option, bool is_positional) const override;
  std::string make_option_usage(const CLI::Option* option) const override;
  std::string make_subcommand(const CLI::App* verb) const override;
};

}  // namespace quadmatch::cli
