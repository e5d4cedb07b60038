// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab/host.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QDir>
#include <QFile>
#include <sstream>
#include <stdexcept>

namespace arete::meshlab::test {
namespace {

using vcg::tri::Allocator;

int progress_calls = 0;
bool count_progress(int, const char*) {
  ++progress_calls;
  return true;
}

}  // namespace

Host& Host::instance() {
  static Host host;
  return host;
}

Host::Host() {
  // A folder with our plugin and the distribution's importer, nothing else.
  QDir folder(ARETE_TEST_PLUGIN_FOLDER);
  RichParameterList globals;
  manager_.loadPlugins(globals, folder);
  for (MeshFilterInterface* filter : manager_.meshFilterPlugins())
    if (filter->pluginName() == "FilterArete") plugin_ = filter;
  if (plugin_ == nullptr) throw std::runtime_error("MeshLab did not load the plugin");
}

QAction& Host::action(const std::string& filter_name) {
  for (QAction* action : plugin_->actions())
    if (action->text() == QString::fromStdString(filter_name)) return *action;
  throw std::runtime_error("no filter " + filter_name);
}

MeshIOInterface& Host::files(const std::string& extension) {
  return *manager_.allKnowInputFormats.value(QString::fromStdString(extension));
}

Document::Document() : mesh_(document_.addNewMesh("", "test")) {}

Document::Document(const MeshArrays& arrays) : Document() {
  Allocator<CMeshO>::AddVertices(cm(), arrays.positions.size());
  Allocator<CMeshO>::AddFaces(cm(), arrays.triangles.size());
  for (std::size_t v = 0; v < arrays.positions.size(); ++v) {
    const Point3& p = arrays.positions[v];
    cm().vert[v].P() = Point3m(float(p[0]), float(p[1]), float(p[2]));
  }
  for (std::size_t f = 0; f < arrays.triangles.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      cm().face[f].V(k) = &cm().vert[std::size_t(arrays.triangles[f][std::size_t(k)])];
      if (!arrays.inner_edges.empty() && ((arrays.inner_edges[f] >> k) & 1)) cm().face[f].SetF(k);
    }
  if (!arrays.inner_edges.empty()) mesh_->updateDataMask(MeshModel::MM_POLYGONAL);
  mesh_->UpdateBoxAndNormals();
}

Document::Document(const std::string& path) : Document() {
  const std::string extension = path.substr(path.rfind('.') + 1);
  int mask = 0;
  if (!Host::instance().files(extension).open(QString::fromStdString(extension),
                                              QString::fromStdString(path), *mesh_, mask, {}))
    throw std::runtime_error("MeshLab cannot open " + path);
  mesh_->Enable(mask);
  mesh_->UpdateBoxAndNormals();
}

RichParameterList Document::dialog(const std::string& filter_name) {
  Host& host = Host::instance();
  RichParameterList list;
  host.plugin().initParameterSet(&host.action(filter_name), document_, list);
  return list;
}

Document::Result Document::apply(const std::string& filter_name,
                                 const std::map<std::string, double>& numbers,
                                 const std::string& scheme_text) {
  Host& host = Host::instance();
  RichParameterList list = dialog(filter_name);
  for (const auto& [name, value] : numbers) {
    const QString key = QString::fromStdString(name);
    const Value& old = list.getParameterByName(key).value();
    if (old.isBool())
      list.setValue(key, BoolValue(value != 0));
    else if (old.isAbsPerc())
      list.setValue(key, AbsPercValue(float(value)));
    else if (old.isEnum())
      list.setValue(key, EnumValue(int(value)));
    else if (old.isInt())
      list.setValue(key, IntValue(int(value)));
    else
      list.setValue(key, FloatValue(float(value)));
  }
  if (!scheme_text.empty())
    list.setValue("SchemeText", StringValue(QString::fromStdString(scheme_text)));
  host.plugin().setLog(&document_.Log);
  const int before = document_.Log.logStringList().size();
  progress_calls = 0;
  Result result;
  result.ok = host.plugin().applyFilter(&host.action(filter_name), document_, list, count_progress);
  result.error = host.plugin().errorMsg().toStdString();
  const auto& lines = document_.Log.logStringList();
  for (int i = before; i < lines.size(); ++i) result.log += lines[i].second.toStdString() + "\n";
  result.progress_calls = progress_calls;
  return result;
}

std::string Document::fingerprint() const {
  std::ostringstream text;
  const CMeshO& cm = mesh_->cm;
  text << mesh_->dataMask() << ' ' << cm.vn << ' ' << cm.fn << ' ' << cm.vert.size() << ' '
       << cm.face.size() << '\n';
  for (const CVertexO& v : cm.vert)
    text << v.cFlags() << v.cP()[0] << ',' << v.cP()[1] << ',' << v.cP()[2] << ',' << v.cN()[0]
         << ',' << v.cQ() << ';';
  for (const CFaceO& f : cm.face) {
    text << f.cFlags();
    for (int k = 0; k < 3; ++k) text << ',' << (f.IsD() ? 0 : vcg::tri::Index(cm, f.cV(k)));
    text << ';';
  }
  return text.str();
}

}  // namespace arete::meshlab::test

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication application(argc, argv);
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
