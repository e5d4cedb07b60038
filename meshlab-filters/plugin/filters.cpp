// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters.h"

#include <exception>
#include <new>

#include "arete/field/error.h"
#include "arete/meshlab/filter_table.h"
#include "convert.h"

namespace arete::meshlab {
namespace {

const Filter& filter(int id) { return filter_table().at(static_cast<std::size_t>(id)); }

QString text(const std::string& utf8) { return QString::fromStdString(utf8); }

MeshFacts facts_of(const MeshModel* mesh) {
  MeshFacts facts;
  if (mesh == nullptr) return facts;
  facts.vertices = mesh->cm.vn;
  facts.polygonal = mesh->hasDataMask(MeshModel::MM_POLYGONAL);
  facts.faces = mesh->cm.fn > 0;
  if (!mesh->cm.bbox.IsNull()) {
    facts.width = mesh->cm.bbox.DimX();
    facts.height = mesh->cm.bbox.DimY();
    facts.diagonal = mesh->cm.bbox.Diag();
  }
  return facts;
}

QStringList choices_of(const Field& field) {
  QStringList choices;
  for (const std::string& choice : field.choices) choices << text(choice);
  return choices;
}

// A parameter that a script left out keeps the default: asking for it would end MeshLab.
std::map<std::string, Values::Value> given_values(const std::vector<Field>& fields,
                                                  const RichParameterList& list) {
  std::map<std::string, Values::Value> given;
  for (const Field& field : fields) {
    const QString name = text(field.name);
    if (!list.hasParameter(name)) continue;
    switch (field.kind) {
      case FieldKind::choice:
        given[field.name] = double(list.getEnum(name));
        break;
      case FieldKind::whole:
        given[field.name] = double(list.getInt(name));
        break;
      case FieldKind::number:
        given[field.name] = typed_number(list.getFloat(name));
        break;
      case FieldKind::length:
        given[field.name] = typed_number(list.getAbsPerc(name));
        break;
      case FieldKind::flag:
        given[field.name] = list.getBool(name) ? 1.0 : 0.0;
        break;
      case FieldKind::text:
        given[field.name] = list.getString(name).toStdString();
        break;
    }
  }
  return given;
}

Progress throttled(vcg::CallBackPos* callback) {
  if (callback == nullptr) return {};
  return [callback, last = -1](int percent, const char* what) mutable {
    if (percent == last) return true;
    last = percent;
    return callback(percent, what);
  };
}

// MeshLab's log takes lines of less than 4096 bytes.
std::string cut_line(std::string line) {
  constexpr std::size_t longest = 4000;
  if (line.size() > longest) line = line.substr(0, longest) + " ...";
  return line;
}

// Nothing is left behind when there is no memory for the new layer.
void add_layer(const Outcome& outcome, MeshModel& source, MeshDocument& document) {
  MeshModel* layer = document.addNewMesh("", text(outcome.created->label), true);
  try {
    write_created(*outcome.created, outcome.keep_quads, source, *layer);
  } catch (...) {
    remove_layer(document, layer);
    document.setCurrentMesh(source.id());
    throw;
  }
}

void apply(const Filter& row, MeshDocument& document, const RichParameterList& parameters,
           vcg::CallBackPos* callback, const std::function<void(const std::string&)>& log) {
  MeshModel* mesh = document.mm();
  const bool needs_mesh = row.effect != Effect::reports;
  if (mesh == nullptr && needs_mesh)
    throw InvalidField("there is no mesh; open a terrain mesh first");
  const std::vector<Field> fields = row.fields(facts_of(mesh));
  const Values values(fields, given_values(fields, parameters));
  Report report(throttled(callback));
  const MeshArrays arrays = needs_mesh ? read_mesh(*mesh) : MeshArrays{};
  const Outcome outcome = row.run(arrays, values, report);
  report.progress(90, "Writing the mesh");
  if (outcome.refined) write_refined(*outcome.refined, outcome.keep_quads, *mesh);
  if (outcome.moved) write_moved(*outcome.moved, *mesh);
  if (outcome.created) add_layer(outcome, *mesh, document);
  if (!outcome.quality.empty()) write_quality(outcome.quality, *mesh);
  for (const std::string& line : report.lines()) log(cut_line(line));
  static const Matrix44m identity = Matrix44m::Identity();
  if (needs_mesh && !(mesh->cm.Tr == identity))
    log(outcome.created ? "The new layer has the matrix of the old one"
                        : "The layer's matrix was neither read nor changed");
  if (callback != nullptr) callback(100, "Done");
}

}  // namespace

int filter_count() { return static_cast<int>(filter_table().size()); }

QString filter_name(int id) { return text(filter(id).name); }

QString filter_info(int id) { return text(filter(id).info); }

FilterBase::FilterClass filter_class(int id) {
  const unsigned menus = filter(id).menus;
  int result = 0;
  if ((menus & remeshing) != 0) result |= FilterBase::Remeshing;
  if ((menus & polygonal) != 0) result |= FilterBase::Polygonal;
  if ((menus & normal) != 0) result |= FilterBase::Normal;
  if ((menus & measure) != 0) result |= FilterBase::Measure;
  if ((menus & point_set) != 0) result |= FilterBase::PointSet;
  if ((menus & sampling) != 0) result |= FilterBase::Sampling;
  return static_cast<FilterBase::FilterClass>(result);
}

int filter_preconditions(int id) {
  if (filter(id).effect == Effect::reports) return MeshModel::MM_NONE;
  return filter(id).needs_faces ? MeshModel::MM_FACENUMBER : MeshModel::MM_NONE;
}

int filter_postcondition(int id) {
  switch (filter(id).effect) {
    case Effect::replaces:
      // Not the attributes, though they are written: MeshLab would switch on those that the mesh
      // does not have. The changed numbers of vertices and faces make it read all of them again.
      return MeshModel::MM_GEOMETRY_AND_TOPOLOGY_CHANGE;
    case Effect::moves:
      return MeshModel::MM_VERTCOORD | MeshModel::MM_VERTNORMAL | MeshModel::MM_FACENORMAL;
    case Effect::creates:
      // The old layer stays. Its quality, which may be written on request, is not told: MeshLab
      // would offer a preview, and make a layer at every turn of a knob.
    case Effect::reports:
      break;
  }
  return MeshModel::MM_NONE;
}

void add_parameters(int id, const MeshModel* mesh, RichParameterList& list) {
  for (const Field& field : filter(id).fields(facts_of(mesh))) {
    const QString name = text(field.name);
    const QString label = text(field.label);
    const QString tooltip = text(field.tooltip);
    switch (field.kind) {
      case FieldKind::choice:
        list.addParam(
            RichEnum(name, static_cast<int>(field.fallback), choices_of(field), label, tooltip));
        break;
      case FieldKind::whole:
        list.addParam(RichInt(name, static_cast<int>(field.fallback), label, tooltip));
        break;
      case FieldKind::number:
        list.addParam(RichFloat(name, static_cast<float>(field.fallback), label, tooltip));
        break;
      case FieldKind::length:
        list.addParam(RichLength(name, static_cast<float>(field.fallback), 0.F,
                                 static_cast<float>(field.highest), label, tooltip));
        break;
      case FieldKind::flag:
        list.addParam(RichBool(name, field.fallback != 0, label, tooltip));
        break;
      case FieldKind::text:
        list.addParam(RichString(name, text(field.text_fallback), label, tooltip));
        break;
    }
  }
}

bool run_filter(int id, MeshDocument& document, const RichParameterList& parameters,
                vcg::CallBackPos* progress, const std::function<void(const std::string& line)>& log,
                QString& error) noexcept {
  std::string message;
  try {
    apply(filter(id), document, parameters, progress, log);
    return true;
  } catch (const std::bad_alloc&) {
    message = "there is not enough memory for the result; use fewer levels";
  } catch (const std::exception& exception) {
    message = exception.what();
  } catch (...) {
    message = "an unknown error";
  }
  try {
    error = text(message).toHtmlEscaped();
    log(cut_line(message));
  } catch (...) {
  }
  return false;
}

}  // namespace arete::meshlab
