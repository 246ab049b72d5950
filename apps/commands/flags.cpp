#include "apps/commands/flags.hpp"

#include "apps/scene/options.hpp"

namespace seiche::apps {

void add_shorthand(CLI::App& verb, const std::string& flag, const std::string& key, std::vector<Override>& overrides,
                   const std::string& type) {
  const auto dot = key.find('.');
  verb.add_option_function<std::string>(
          flag,
          [&overrides, flag, key](const std::string& value) {
            overrides.push_back({flag + " " + value, key, value});
          },
          "short for --set " + key + "=...: " + expected(*find_option(key.substr(0, dot), key.substr(dot + 1))))
      ->type_name(type)
      ->take_last();
}

void add_set(CLI::App& verb, std::vector<Override>& overrides, const std::string& help) {
  verb.add_option_function<std::vector<std::string>>(
          "--set",
          [&overrides](const std::vector<std::string>& all) {
            for (const std::string& each : all) overrides.push_back(parse_set(each));
          },
          help + "; can be given several times")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

void add_movie_format(CLI::App& verb, render::MovieFormat& format, const std::string& help) {
  std::vector<std::string> names;
  for (const auto& row : ChoiceTable<render::MovieFormat>::rows)
    if (row.value != render::MovieFormat::none) names.emplace_back(row.name);
  CLI::Option* option = verb.add_option_function<std::string>(
      "--movie", [&format](const std::string& text) { format = value_named<render::MovieFormat>(text); }, help);
  option->check(CLI::IsMember(names))->type_name("FORMAT");
  if (format != render::MovieFormat::none) option->default_str(std::string(name(format)));
}

}  // namespace seiche::apps
