// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin_2021.h"

#include "filters.h"

using namespace arete::meshlab;

AreteFilterPlugin::AreteFilterPlugin() {
  for (ActionIDType id = 0; id < filter_count(); ++id) {
    typeList.push_back(id);
    actionList.push_back(new QAction(filter_name(id), this));
  }
}

QString AreteFilterPlugin::pluginName() const { return "FilterArete"; }

QString AreteFilterPlugin::vendor() const { return "arete"; }

QString AreteFilterPlugin::filterName(ActionIDType id) const { return filter_name(id); }

QString AreteFilterPlugin::filterInfo(ActionIDType id) const { return filter_info(id); }

AreteFilterPlugin::FilterClass AreteFilterPlugin::getClass(const QAction* action) const {
  return filter_class(ID(action));
}

AreteFilterPlugin::FilterArity AreteFilterPlugin::filterArity(const QAction*) const {
  return SINGLE_MESH;
}

int AreteFilterPlugin::getRequirements(const QAction*) { return MeshModel::MM_NONE; }

int AreteFilterPlugin::getPreConditions(const QAction* action) const {
  return filter_preconditions(ID(action));
}

int AreteFilterPlugin::postCondition(const QAction* action) const {
  return filter_postcondition(ID(action));
}

RichParameterList AreteFilterPlugin::initParameterList(const QAction* action,
                                                       const MeshDocument& document) {
  RichParameterList list;
  add_parameters(ID(action), document.mm(), list);
  return list;
}

std::map<std::string, QVariant> AreteFilterPlugin::applyFilter(const QAction* action,
                                                               const RichParameterList& parameters,
                                                               MeshDocument& document,
                                                               unsigned int& post_condition,
                                                               vcg::CallBackPos* progress) {
  const auto write_line = [this](const std::string& line) { log("%s", line.c_str()); };
  QString error;
  if (!run_filter(ID(action), document, parameters, progress, write_line, error))
    throw MLException(error);
  post_condition = static_cast<unsigned int>(postCondition(action));
  return {};
}
