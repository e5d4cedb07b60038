// SPDX-License-Identifier: MIT
// Completes the server-manager XML of the filters: write_filter_panels TEMPLATE OUT. One proxy a
// family of the catalogue, with a slider a parameter, one for the text form, and the properties
// that several filters share.
#include <cctype>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <sstream>

#include "arete/field/boundary.h"
#include "arete/scheme/catalogue.h"

namespace {

using arete::Family;
using arete::Parameter;
using arete::ParameterKind;

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '&':
        result += "&amp;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

// `four-parameter-c2` -> `FourParameterC2`: what a proxy may be called.
std::string identifier(const std::string& name) {
  std::string result;
  bool capital = true;
  for (const char c : name) {
    if (c == '-' || c == '_') {
      capital = true;
      continue;
    }
    result += capital ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    capital = false;
  }
  return result;
}

std::string number(const arete::Rational& value) {
  std::ostringstream text;
  text.precision(17);
  text << arete::to_double(value);
  return text.str();
}

std::string documentation(const std::string& text, const char* indent) {
  return std::string(indent) + "<Documentation>" + escaped(text) + "</Documentation>\n";
}

// Families with numbers only; those with lists are reached through the text form.
bool has_sliders(const Family& family) {
  for (const Parameter& p : family.parameters)
    if (!p.fallback || p.repeats || p.kind == ParameterKind::list) return false;
  return true;
}

// Names begin with "Parameter" so that they come after "Family", which forgets the parameters.
std::string slider(const Parameter& p) {
  const bool whole = p.kind == ParameterKind::integer;
  // vtkAreteScheme takes a floating point number for either kind.
  const std::string kind = whole ? "Int" : "Double";
  return "      <" + kind + "VectorProperty name=\"Parameter" + identifier(p.name) + "\" label=\"" +
         identifier(p.name) + "\" command=\"SetParameter\" initial_string=\"" + p.name +
         "\" number_of_elements=\"1\" default_values=\"" + number(*p.fallback) + "\">\n" +
         "        <" + kind + "RangeDomain name=\"range\" min=\"" + number(p.usual.lowest) +
         "\" max=\"" + number(p.usual.highest) + "\"/>\n" +
         documentation(p.meaning + " (" + p.symbol + "); accepted from " +
                           arete::to_string(p.accepted.lowest) + " to " +
                           arete::to_string(p.accepted.highest),
                       "        ") +
         "      </" + kind + "VectorProperty>\n";
}

std::string proxy(const Family& family) {
  std::string xml = "    <Proxy name=\"" + identifier(family.name) +
                    "\" class=\"vtkAreteScheme\" label=\"" + family.name + "\">\n" +
                    documentation(family.summary, "      ") +
                    "      <StringVectorProperty name=\"Family\" command=\"SetFamily\" "
                    "number_of_elements=\"1\" default_values=\"" +
                    family.name + "\" panel_visibility=\"never\"/>\n";
  for (const Parameter& p : family.parameters) xml += slider(p);
  return xml + "    </Proxy>\n";
}

std::string text_proxy() {
  return "    <Proxy name=\"SchemeText\" class=\"vtkAreteScheme\" label=\"text form\">\n"
         "      <Documentation>Any scheme as text: name or name:key=value,key=value with decimal "
         "or "
         "rational values, for example four-parameter:lambda=7/32,mu=7/32,nu=1/2,omega=3/64 or "
         "mask:arity=2,first=-1,coefficients=1/2;1;1/2</Documentation>\n"
         "      <StringVectorProperty name=\"Text\" command=\"SetText\" number_of_elements=\"1\" "
         "default_values=\"four-parameter:lambda=7/32,mu=7/32,nu=1/2,omega=3/64\"/>\n"
         "    </Proxy>\n";
}

std::string scheme_proxies() {
  std::string xml;
  for (const Family& family : arete::catalogue())
    if (has_sliders(family)) xml += proxy(family);
  return xml + text_proxy();
}

// The landscape that refines most gently comes first and so is the initial choice.
std::string scheme_property() {
  std::string xml =
      "      <ProxyProperty name=\"Scheme\" command=\"SetSchemeObject\">\n"
      "        <ProxyListDomain name=\"proxy_list\">\n";
  const auto entry = [&](const std::string& name) {
    xml += "          <Proxy group=\"arete_schemes\" name=\"" + name + "\"/>\n";
  };
  entry("Gentle");
  for (const Family& family : arete::catalogue())
    if (has_sliders(family) && family.name != "gentle") entry(identifier(family.name));
  entry("SchemeText");
  return xml + "        </ProxyListDomain>\n" +
         documentation("The subdivision scheme and its parameters.", "        ") +
         "      </ProxyProperty>\n"
         "      <StringVectorProperty name=\"SchemeY\" label=\"Scheme Along Y\" "
         "command=\"SetSchemeY\" number_of_elements=\"1\" default_values=\"\" "
         "panel_visibility=\"advanced\">\n" +
         documentation("Another scheme along y, in its text form; empty: the same.", "        ") +
         "      </StringVectorProperty>\n";
}

std::string boundary_property(const std::string& axis, bool with_none) {
  std::string xml = "      <IntVectorProperty name=\"Boundary" + axis + "\" label=\"Boundary " +
                    axis + "\" command=\"SetBoundary" + axis +
                    "\" number_of_elements=\"1\" default_values=\"0\">\n"
                    "        <EnumerationDomain name=\"enum\">\n";
  for (int rule = 0; rule <= static_cast<int>(arete::Boundary::none); ++rule) {
    const auto boundary = static_cast<arete::Boundary>(rule);
    if (boundary == arete::Boundary::none && !with_none) continue;
    xml += "          <Entry value=\"" + std::to_string(rule) + "\" text=\"" +
           identifier(std::string(to_string(boundary))) + "\"/>\n";
  }
  return xml + "        </EnumerationDomain>\n" +
         documentation("How the data are continued beyond their ends along " + axis + ".",
                       "        ") +
         "      </IntVectorProperty>\n";
}

const char* const levels_property =
    R"(      <IntVectorProperty name="Levels" command="SetLevels" number_of_elements="1" default_values="1">
        <IntRangeDomain name="range" min="0" max="8"/>
        <Documentation>How often the scheme is applied. Each level of a binary scheme makes four times as many points.</Documentation>
      </IntVectorProperty>
)";
const char* const limit_property =
    R"(      <IntVectorProperty name="Limit" command="SetLimit" number_of_elements="1" default_values="0">
        <BooleanDomain name="bool"/>
        <Documentation>Give the limit of infinitely many levels at the new points (schemes that are certified to have one).</Documentation>
      </IntVectorProperty>
)";
const char* const threads_property =
    R"(      <IntVectorProperty name="NumberOfThreads" label="Threads" command="SetNumberOfThreads" number_of_elements="1" default_values="0" panel_visibility="advanced">
        <IntRangeDomain name="range" min="0" max="256"/>
        <Documentation>0: as many as the machine has. The result does not depend on it.</Documentation>
      </IntVectorProperty>
)";

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: write_filter_panels TEMPLATE OUT\n";
    return 2;
  }
  std::ifstream form(argv[1]);
  if (!form) {
    std::cerr << "write_filter_panels: cannot read " << argv[1] << '\n';
    return 1;
  }
  std::string text{std::istreambuf_iterator<char>(form), std::istreambuf_iterator<char>()};
  const std::map<std::string, std::string> parts{
      {"@SCHEME_PROXIES@\n", scheme_proxies()},
      {"@SCHEME@\n", scheme_property()},
      {"@LEVELS@\n", levels_property},
      {"@LIMIT@\n", limit_property},
      {"@THREADS@\n", threads_property},
      {"@BOUNDARY@\n", boundary_property("X", true) + boundary_property("Y", true)},
      {"@BOUNDARY_WITHOUT_NONE@\n", boundary_property("X", false) + boundary_property("Y", false)}};
  for (const auto& [mark, part] : parts)
    for (auto at = text.find(mark); at != std::string::npos; at = text.find(mark, at + part.size()))
      text.replace(at, mark.size(), part);
  if (text.find('@') != std::string::npos) {
    std::cerr << "write_filter_panels: " << argv[1] << " has a mark that is not known\n";
    return 1;
  }
  std::ofstream file(argv[2]);
  file << text;
  return file.flush() ? 0 : 1;
}
