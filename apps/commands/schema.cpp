#include "apps/commands/schema.hpp"

#include <fmt/format.h>

#include <memory>

#include "apps/commands/help.hpp"
#include "apps/scene/json_schema.hpp"
#include "apps/scene/key_tables.hpp"

namespace seiche::apps {

void add_schema(CLI::App& app) {
  CLI::App* verb =
      app.add_subcommand("schema", "Print the JSON Schema of scene files, for editors that complete and check")
          ->group("Verbs")
          ->footer(help::schema_footer);
  const auto markdown = std::make_shared<bool>(false);
  verb->add_flag("--markdown", *markdown, "print tables of all keys instead, as in scenes/README.md");
  verb->callback([markdown] { fmt::print("{}", *markdown ? key_tables() : scene_json_schema()); });
}

}  // namespace seiche::apps
