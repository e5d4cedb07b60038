// SPDX-License-Identifier: MIT
#include "arete/scheme/catalogue.h"
#include "cli/manual.h"
#include "cli/option_facts.h"

namespace arete::cli {
namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

bool wants_scheme(const CLI::Option& option) {
  const std::vector<std::string> names = spellings(option);
  return names.empty() ? option.get_name(true) == "SCHEME" : names.back().rfind("--scheme", 0) == 0;
}

// What may follow an option: a fixed set of words, or the names of the catalogue.
std::string words_after(const CLI::Option& option, const std::string& schemes) {
  return wants_scheme(option) ? schemes : joined(accepted_words(option));
}

}  // namespace

std::string bash_completion(const CLI::App& program) {
  std::vector<std::string> names;
  for (const Family& family : catalogue()) names.push_back(family.name);
  const std::string schemes = joined(names);

  std::vector<std::string> verbs;
  std::string cases;
  for (const CLI::App* verb : visible_verbs(program)) {
    verbs.push_back(verb->get_name());
    std::vector<std::string> options;
    std::string after;
    bool scheme_first = false;
    for (const CLI::Option* option : verb->get_options()) {
      const std::vector<std::string> spelled = spellings(*option);
      options.insert(options.end(), spelled.begin(), spelled.end());
      if (spelled.empty() && wants_scheme(*option)) scheme_first = true;
      if (spelled.empty() || !takes_value(*option)) continue;
      std::string pattern;
      for (const std::string& name : spelled) pattern += (pattern.empty() ? "" : "|") + name;
      const std::string words = words_after(*option, schemes);
      // Options with free values complete file names, which is right for all that name files.
      after += "        " + pattern + ") " +
               (words.empty() ? "COMPREPLY=($(compgen -f -- \"$current\"))"
                              : "COMPREPLY=($(compgen -W \"" + words + "\" -- \"$current\"))") +
               "; return ;;\n";
    }
    cases += "    " + verb->get_name() + ")\n      options=\"" + joined(options) + "\"\n";
    if (scheme_first) cases += "      words=\"" + schemes + "\"\n";
    if (!after.empty()) cases += "      case $previous in\n" + after + "      esac\n";
    cases += "      ;;\n";
  }
  return "# Completion of arete for bash; written by the program itself.\n"
         "_arete() {\n"
         "  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]}\n"
         "  local options= words=\n"
         "  COMPREPLY=()\n"
         "  if ((COMP_CWORD == 1)); then\n"
         "    COMPREPLY=($(compgen -W \"" +
         joined(verbs) +
         " --help --version\" -- \"$current\"))\n"
         "    return\n"
         "  fi\n"
         "  case ${COMP_WORDS[1]} in\n" +
         cases +
         "  esac\n"
         "  if [[ $current == -* ]]; then\n"
         "    COMPREPLY=($(compgen -W \"$options\" -- \"$current\"))\n"
         "  elif [[ -n $words && $COMP_CWORD -eq 2 ]]; then\n"
         "    COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n"
         "  else\n"
         "    COMPREPLY=($(compgen -f -- \"$current\"))\n"
         "  fi\n"
         "}\n"
         "complete -o filenames -o bashdefault -F _arete arete\n";
}

}  // namespace arete::cli
