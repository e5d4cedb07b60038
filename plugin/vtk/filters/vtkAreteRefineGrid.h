// SPDX-License-Identifier: MIT
/**
 * @class   vtkAreteRefineGrid
 * @brief   refine a structured grid, or polygons that form a grid, by a subdivision scheme
 *
 * Points are moved and inserted by the scheme in all three coordinates. Point data follow by the
 * same weights or linearly (SetPointData()), cell data come from the parent cell.
 *
 * Inputs:
 * - vtkStructuredGrid: rows and columns along i and j; slices along k are refined one by one. Gives
 *   a vtkStructuredGrid that can be asked for in pieces, each of them equal to the same part of the
 *   whole to the last bit. Hidden points (vtkGhostType) are missing, see vtkAreteRefineImage; their
 *   successors stay hidden, with coordinates between those of the input.
 * - vtkPolyData: every connected part must be a grid of quads (open, a cylinder, or a torus) or a
 *   triangulated open grid. Parts are found by topology, whatever the numbering; an axis that wraps
 *   is refined as a closed one. Gives vtkPolyData of the same kind of faces. What is no grid is an
 *   error that names the point or cell. Polygons come as one piece: further pieces are empty.
 *
 * Normals that are active point normals are interpolated and made unit length again.
 */
#ifndef vtkAreteRefineGrid_h
#define vtkAreteRefineGrid_h

#include "vtkAreteFilter.h"

class ARETEFILTERS_EXPORT vtkAreteRefineGrid : public vtkAreteFilter {
 public:
  static vtkAreteRefineGrid* New();
  vtkTypeMacro(vtkAreteRefineGrid, vtkAreteFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * How point data are refined.
   */
  enum PointDataRule {
    SCHEME = 0,  ///< by the weights of the scheme, as the points
    LINEAR = 1   ///< bilinearly, so that no value leaves the range of its neighbours
  };

  ///@{
  /**
   * How often the scheme is applied; 0 to 30. Initial value: 1.
   */
  vtkSetClampMacro(Levels, int, 0, 30);
  vtkGetMacro(Levels, int);
  ///@}

  ///@{
  /**
   * One of PointDataRule. Initial value: SCHEME.
   */
  vtkSetClampMacro(PointData, int, SCHEME, LINEAR);
  vtkGetMacro(PointData, int);
  ///@}

  ///@{
  /**
   * Give points of the limit surface instead of those of level N. Initial value: off.
   */
  vtkSetMacro(Limit, vtkTypeBool);
  vtkGetMacro(Limit, vtkTypeBool);
  vtkBooleanMacro(Limit, vtkTypeBool);
  ///@}

 protected:
  vtkAreteRefineGrid();
  ~vtkAreteRefineGrid() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Levels = 1;
  int PointData = SCHEME;
  vtkTypeBool Limit = 0;

 private:
  vtkAreteRefineGrid(const vtkAreteRefineGrid&) = delete;
  void operator=(const vtkAreteRefineGrid&) = delete;

  int RefineStructured(vtkInformation* in, vtkInformation* out);
  int RefinePolygons(vtkInformation* in, vtkInformation* out);
};

#endif
