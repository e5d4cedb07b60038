// SPDX-License-Identifier: MIT
#include "cli/manual.h"

#include <algorithm>

#include "cli/option_facts.h"

namespace arete::cli {
namespace {

// Text for roff: no line may begin with a control character, and hyphens stay hyphens.
std::string roff(const std::string& text) {
  std::string escaped;
  bool line_begins = true;
  for (const char c : text) {
    if (line_begins && (c == '.' || c == '\'')) escaped += "\\&";
    if (c == '\\')
      escaped += "\\e";
    else if (c == '-')
      escaped += "\\-";
    else
      escaped += c;
    line_begins = c == '\n';
  }
  return escaped;
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

// A sentence of an option's description, then what it accepts and what holds without it.
std::string explanation(const CLI::Option& option) {
  std::string text = roff(option.get_description());
  const std::vector<std::string> words = accepted_words(option);
  // Help texts are sentences without their full stop.
  if (!text.empty() && text.back() != '.') text += ".";
  if (!words.empty()) {
    text += "\nOne of";
    for (std::size_t i = 0; i < words.size(); ++i)
      text += (i == 0 ? " " : ", ") + ("\\fB" + roff(words[i]) + "\\fR");
    text += ".";
  }
  if (!option.get_default_str().empty())
    text += "\nDefault: \\fB" + roff(option.get_default_str()) + "\\fR.";
  return text;
}

std::string value_name(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::string name = type.substr(0, type.find_first_of(":{ ["));
  return name.empty() ? "VALUE" : name;
}

void append_entry(std::string& page, const std::string& term, const CLI::Option& option) {
  page += ".TP\n" + term + "\n" + explanation(option) + "\n";
}

void append_options(std::string& page, const CLI::App& app) {
  std::string arguments;
  std::string options;
  for (const CLI::Option* option : app.get_options()) {
    const std::vector<std::string> names = spellings(*option);
    if (names.empty()) {
      append_entry(arguments, "\\fI" + roff(option->get_name(true)) + "\\fR", *option);
      continue;
    }
    std::string term;
    for (const std::string& name : names)
      term += (term.empty() ? "\\fB" : ", \\fB") + roff(name) + "\\fR";
    if (takes_value(*option)) term += " \\fI" + roff(value_name(*option)) + "\\fR";
    append_entry(options, term, *option);
  }
  if (!arguments.empty()) page += ".SH ARGUMENTS\n" + arguments;
  if (!options.empty()) page += ".SH OPTIONS\n" + options;
}

std::string heading(const std::string& name, const std::string& version,
                    const std::string& summary) {
  // The name line must be one line for apropos; what follows the first sentence goes below.
  std::string line = summary.substr(0, summary.find_first_of("\n"));
  return ".TH " + upper(name) + " 1 \"\" \"" + version + "\" \"User Commands\"\n.SH NAME\n" +
         roff(name) + " \\- " + roff(line) + "\n";
}

const char* const exit_status =
    ".SH EXIT STATUS\n0 done, 1 failed, 2 misuse, 130 interrupted. Errors are one line on standard "
    "error. An output file appears only when it is complete.\n";

ManualPage verb_page(const CLI::App& verb, const std::string& version) {
  const std::string name = "arete-" + verb.get_name();
  std::string page = heading(name, version, verb.get_description());
  page += ".SH SYNOPSIS\n.B arete " + roff(verb.get_name()) + "\n";
  for (const CLI::Option* option : verb.get_options())
    if (spellings(*option).empty()) {
      const std::string argument = "\\fI" + roff(option->get_name(true)) + "\\fR";
      page += option->get_required() ? argument + "\n" : "[" + argument + "]\n";
    } else if (option->get_required()) {
      page += "\\fB" + roff(spellings(*option).back()) + "\\fR \\fI" + roff(value_name(*option)) +
              "\\fR\n";
    }
  page += "[\\fIoptions\\fR]\n.SH DESCRIPTION\n" + roff(verb.get_description()) + "\n";
  append_options(page, verb);
  if (!verb.get_footer().empty()) page += ".SH NOTES\n" + roff(verb.get_footer()) + "\n";
  page += std::string(exit_status) + ".SH SEE ALSO\n.BR arete (1)\n";
  return {name + ".1", page};
}

}  // namespace

std::vector<ManualPage> manual_pages(const CLI::App& program, const std::string& version) {
  std::string page = heading("arete", version, "parametric subdivision for terrain");
  page += ".SH SYNOPSIS\n.B arete\n\\fIverb\\fR [\\fIoptions\\fR]\n.SH DESCRIPTION\n" +
          roff(program.get_description()) + "\n.SH VERBS\n";
  std::string see_also;
  std::vector<ManualPage> pages;
  for (const CLI::App* verb : visible_verbs(program)) {
    page += ".TP\n\\fB" + roff(verb->get_name()) + "\\fR\n" + roff(verb->get_description()) + "\n";
    see_also +=
        (see_also.empty() ? "" : " ,\n") + (".BR arete\\-" + roff(verb->get_name())) + " (1)";
    pages.push_back(verb_page(*verb, version));
  }
  append_options(page, program);
  page += std::string(exit_status) + ".SH SEE ALSO\n" + see_also + "\n";
  pages.insert(pages.begin(), {"arete.1", page});
  return pages;
}

}  // namespace arete::cli
