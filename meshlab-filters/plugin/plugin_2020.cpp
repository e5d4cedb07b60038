// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin_2020.h"

#include "filters.h"

using namespace arete::meshlab;

AreteFilterPlugin::AreteFilterPlugin() {
  for (FilterIDType id = 0; id < filter_count(); ++id) {
    typeList << id;
    actionList << new QAction(filter_name(id), this);
  }
}

QString AreteFilterPlugin::pluginName() const { return "FilterArete"; }

QString AreteFilterPlugin::filterName(FilterIDType id) const { return filter_name(id); }

QString AreteFilterPlugin::filterInfo(FilterIDType id) const { return filter_info(id); }

AreteFilterPlugin::FilterClass AreteFilterPlugin::getClass(QAction* action) {
  return filter_class(ID(action));
}

AreteFilterPlugin::FILTER_ARITY AreteFilterPlugin::filterArity(QAction*) const {
  return SINGLE_MESH;
}

int AreteFilterPlugin::getRequirements(QAction*) { return MeshModel::MM_NONE; }

int AreteFilterPlugin::getPreConditions(QAction* action) const {
  return filter_preconditions(ID(action));
}

int AreteFilterPlugin::postCondition(QAction* action) const {
  return filter_postcondition(ID(action));
}

void AreteFilterPlugin::initParameterSet(QAction* action, MeshDocument& document,
                                         RichParameterList& list) {
  add_parameters(ID(action), document.mm(), list);
}

bool AreteFilterPlugin::applyFilter(QAction* action, MeshDocument& document,
                                    const RichParameterList& parameters,
                                    vcg::CallBackPos* progress) {
  const auto log = [this](const std::string& line) { Log("%s", line.c_str()); };
  errorMessage.clear();
  return run_filter(ID(action), document, parameters, progress, log, errorMessage);
}
