// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "compat.h"

namespace arete::meshlab {

/// The table of filters in MeshLab's words: the same for every release. `id` is a position in
/// filter_table().
[[nodiscard]] int filter_count();
[[nodiscard]] QString filter_name(int id);
[[nodiscard]] QString filter_info(int id);
[[nodiscard]] FilterBase::FilterClass filter_class(int id);
[[nodiscard]] int filter_preconditions(int id);
[[nodiscard]] int filter_postcondition(int id);

/// The fields of the dialog; `mesh` may be null.
void add_parameters(int id, const MeshModel* mesh, RichParameterList& list);

/// Applies a filter to the current mesh. False: `error` says why, as HTML text, and the document is
/// untouched. There may be no mesh; `progress` may be null.
[[nodiscard]] bool run_filter(int id, MeshDocument& document, const RichParameterList& parameters,
                              vcg::CallBackPos* progress,
                              const std::function<void(const std::string& line)>& log,
                              QString& error) noexcept;

}  // namespace arete::meshlab
