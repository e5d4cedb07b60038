// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compat.h"

/// The filters for MeshLab 2021.05 and later: signatures only.
class AreteFilterPlugin : public QObject, public FilterPlugin {
  Q_OBJECT
  MESHLAB_PLUGIN_IID_EXPORTER(FILTER_PLUGIN_IID)
  Q_INTERFACES(FilterPlugin)

 public:
  AreteFilterPlugin();

  QString pluginName() const override;
  QString vendor() const override;
  QString filterName(ActionIDType id) const override;
  QString filterInfo(ActionIDType id) const override;
  FilterClass getClass(const QAction* action) const override;
  FilterArity filterArity(const QAction* action) const override;
  int getRequirements(const QAction* action) override;
  int getPreConditions(const QAction* action) const override;
  int postCondition(const QAction* action) const override;
  RichParameterList initParameterList(const QAction* action, const MeshDocument& document) override;
  std::map<std::string, QVariant> applyFilter(const QAction* action,
                                              const RichParameterList& parameters,
                                              MeshDocument& document, unsigned int& post_condition,
                                              vcg::CallBackPos* progress) override;
};
