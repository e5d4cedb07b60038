// SPDX-License-Identifier: MIT
// Touches every installed component, so that headers, libraries and their dependencies are there.
#include <arete/refine/refiner.h>
#include <arete/scheme/catalogue.h>
#ifdef WITH_GDAL
#include <arete/gdal/raster.h>
#endif
#ifdef WITH_VTK
#include <arete/vtk/write_image.h>
#include <vtkAreteRefineImage.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#endif
#ifdef WITH_OPENMESH
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include <arete/openmesh/grid_subdivider.h>
#include <arete/openmesh/mesh_io.h>
#endif
#ifdef WITH_OPENSUBDIV
#include <arete/opensubdiv/catmull_clark.h>
#endif

#include <exception>

int main() {
  const arete::Grid<double> fine =
      arete::refine(arete::Grid<double>({4, 5}, 3), arete::parse_scheme("gentle"));
  if (fine.extent() != arete::Extent{7, 9}) return 1;
#ifdef WITH_GDAL
  try {
    const arete::gdal::Raster raster("/absent.tif");
    return 2;
  } catch (const arete::gdal::RasterError&) {
  }
#endif
#ifdef WITH_VTK
  try {
    arete::vtk::write_image({fine.view()}, "/absent/folder/image.vti");
    return 3;
  } catch (const std::exception&) {
  }
  const vtkNew<vtkImageData> image;
  image->SetDimensions(5, 4, 1);
  const vtkNew<vtkAreteRefineImage> filter;
  filter->SetInputData(image);
  filter->Update();
  if (filter->GetOutput()->GetNumberOfPoints() != 63) return 4;
#endif
#ifdef WITH_OPENMESH
  using Mesh = OpenMesh::PolyMesh_ArrayKernelT<>;
  Mesh mesh;
  mesh.request_vertex_normals();
  for (int i = 0; i < 6; ++i)
    mesh.add_vertex({static_cast<float>(i % 3), static_cast<float>(i / 3), 0});
  const auto v = [](int i) { return Mesh::VertexHandle(i); };
  mesh.add_face(v(0), v(1), v(4), v(3));
  mesh.add_face(v(1), v(2), v(5), v(4));
  arete::openmesh::GridSubdividerT<Mesh> subdivide("four-point");
  if (!subdivide(mesh, 2) || mesh.n_vertices() != 5 * 9) return 4;
  if (mesh.normal(v(0)) != Mesh::Normal(0, 0, 1)) return 5;
  try {
    (void)arete::openmesh::read_mesh("/absent.obj");
    return 6;
  } catch (const arete::openmesh::MeshFileError&) {
  }
#endif
#ifdef WITH_OPENSUBDIV
  const arete::Grid<double> flat({3, 3}, 3);
  if (arete::opensubdiv::catmull_clark(flat, 1, arete::opensubdiv::CornerRule::sharp)(2, 2) != 3)
    return 7;
#endif
  return 0;
}
