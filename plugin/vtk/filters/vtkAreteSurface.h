// SPDX-License-Identifier: MIT
/**
 * @class   vtkAreteSurface
 * @brief   an image of heights as polygons, with the normals of its limit surface
 *
 * Every point of the image becomes a point in space, raised by its height along the image's third
 * direction, and every whole cell a quad. The heights are those of SetInputArrayToProcess(0, ...),
 * by default the active point scalars; other point and cell data are passed on.
 *
 * Point data of the output besides:
 * - "Normals": of the limit surface of the scheme at the point, where the scheme is certified C^1
 * along both axes; otherwise of central differences. Field data "AreteNormals" says which. Refine
 * an image with vtkAreteRefineImage and the same scheme, and these are the exact normals.
 * - "Slope": degrees from level.
 * - "TextureCoordinates": the picture is laid over the box of the pixels, half a pixel beyond the
 *   outermost points; t runs with j.
 *
 * Missing heights (not finite, or hidden by vtkGhostType) leave holes, see SetMissing().
 *
 * In pieces, each has the very points of the whole (border points in both).
 */
#ifndef vtkAreteSurface_h
#define vtkAreteSurface_h

#include "vtkAreteFilter.h"

class ARETEFILTERS_EXPORT vtkAreteSurface : public vtkAreteFilter {
 public:
  static vtkAreteSurface* New();
  vtkTypeMacro(vtkAreteSurface, vtkAreteFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What becomes of missing heights.
   */
  enum MissingMode {
    DROP = 0,  ///< points that no whole quad uses, and quads with a missing corner, are left out
    BLANK = 1  ///< all are kept, at height 0, and hidden by vtkGhostType of points and cells
  };

  ///@{
  /**
   * One of MissingMode. Initial value: DROP.
   */
  vtkSetClampMacro(Missing, int, DROP, BLANK);
  vtkGetMacro(Missing, int);
  ///@}

  ///@{
  /**
   * Raise points to the limit surface instead of the heights themselves. Schemes without a
   * certified limit are refused. Initial value: off.
   */
  vtkSetMacro(Limit, vtkTypeBool);
  vtkGetMacro(Limit, vtkTypeBool);
  vtkBooleanMacro(Limit, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Heights are multiplied by this before anything else. Initial value: 1.
   */
  vtkSetMacro(ScaleFactor, double);
  vtkGetMacro(ScaleFactor, double);
  ///@}

 protected:
  vtkAreteSurface();
  ~vtkAreteSurface() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Missing = DROP;
  vtkTypeBool Limit = 0;
  double ScaleFactor = 1;

 private:
  vtkAreteSurface(const vtkAreteSurface&) = delete;
  void operator=(const vtkAreteSurface&) = delete;
};

#endif
