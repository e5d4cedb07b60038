# SPDX-License-Identifier: MIT
"""The plugin in ParaView: it loads, stands in the menu's category, and its panels agree with the
catalogue. Run by pvpython: panels_test.py PLUGIN SCHEMES.json (from arete schemes --json)."""
import json
import sys
from fractions import Fraction

from paraview import servermanager
from paraview.simple import LoadPlugin, Wavelet

plugin, catalogue = sys.argv[1:3]
LoadPlugin(plugin, remote=False, ns=globals())
with open(catalogue) as file:
    families = json.load(file)["schemes"]

definitions = servermanager.ProxyManager().GetProxyDefinitionManager()


def children(element, tag=None):
    all_of_them = [element.GetNestedElement(i) for i in range(element.GetNumberOfNestedElements())]
    return [child for child in all_of_them if tag is None or child.GetName() == tag]


def identifier(name):
    return "".join(word[:1].upper() + word[1:] for word in name.split("-"))


for name in ("AreteRefineImage", "AreteRefineGrid", "AreteSurface", "AreteCoarsen", "AreteRestore"):
    xml = definitions.GetProxyDefinition("filters", name)
    assert xml, f"{name} is not defined"
    menu = xml.FindNestedElementByName("Hints").FindNestedElementByName("ShowInMenu")
    assert menu.GetAttribute("category") == "Arete", name
    for part in children(xml):
        if part.GetName().endswith("Property"):
            assert part.FindNestedElementByName("Documentation"), (name, part.GetAttribute("name"))

refine = AreteRefineImage(Input=Wavelet(WholeExtent=[0, 5, 0, 4, 0, 0]))  # noqa: F821
assert refine.Scheme.SMProxy.GetXMLLabel() == "gentle", "the initial choice"
offered = list(refine.GetProperty("Scheme").Available)
checked = sliders = 0
for family in families:
    name, parameters = family["name"], family["parameters"]
    plain = all(p["default"] is not None and p["kind"] != "list" and not p["repeats"]
                for p in parameters)
    assert (name in offered) == plain, (name, offered)
    if not plain:
        continue
    panel = {part.GetAttribute("name"): part
             for part in children(definitions.GetProxyDefinition("arete_schemes",
                                                                 identifier(name)))}
    refine.Scheme = name
    checked += 1
    for p in parameters:
        slider = "Parameter" + identifier(p["name"])
        chosen = refine.Scheme.SMProxy.GetProperty(slider).GetElement(0)
        assert chosen == float(Fraction(p["default"])), (name, p, chosen)
        kind = "IntRangeDomain" if p["kind"] == "integer" else "DoubleRangeDomain"
        (domain,) = children(panel[slider], kind)
        for end, value in zip(("min", "max"), p["usual"]):
            assert float(domain.GetAttribute(end)) == float(Fraction(value)), (name, p)
        sliders += 1
    assert len(panel) == len(parameters) + 2, (name, list(panel))  # and Family, Documentation
    refine.UpdatePipeline()
    assert refine.GetDataInformation().GetNumberOfPoints() > 30, name
assert "text form" in offered
assert len(offered) == checked + 1
assert checked > 12 and sliders > 15

# A slider reaches the filter.
refine.Scheme = "four-point"
refine.Levels = 1
refine.UpdatePipeline()
before = refine.PointData["RTData"].GetRange()
refine.Scheme.Omega = 0.25
refine.UpdatePipeline()
assert refine.PointData["RTData"].GetRange() != before
print(f"{checked} families, {sliders} sliders")
