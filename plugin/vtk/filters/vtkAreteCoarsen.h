// SPDX-License-Identifier: MIT
/**
 * @class   vtkAreteCoarsen
 * @brief   undo refinement: an image taken apart into a coarse one and the details that restore it
 *
 * Reverse subdivision of all point arrays with numbers, every component by itself, in double. The
 * details go with the coarse image as field data "AreteDetails" (bytes, the format of arete's
 * details files), so that VTK's own readers and writers keep both together; vtkAreteRestore puts
 * them back. Cell data are dropped.
 *
 * The extent of the result begins at 0; its origin and spacing say where its points lie.
 *
 * Missing points (hidden or not finite) get a value before the filters run over them and come back
 * as missing; those of the coarse image are NaN, and hidden if the input hides points.
 *
 * Coarse values depend on the whole image, so the filter always asks for all of it.
 *
 * SchemeY must be empty: both axes are taken apart by one scheme. Boundary NONE is refused.
 */
#ifndef vtkAreteCoarsen_h
#define vtkAreteCoarsen_h

#include "vtkAreteFilter.h"

class ARETEFILTERS_EXPORT vtkAreteCoarsen : public vtkAreteFilter {
 public:
  static vtkAreteCoarsen* New();
  vtkTypeMacro(vtkAreteCoarsen, vtkAreteFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * How coarse values are found.
   */
  enum ReverseMode {
    LOCAL = 0,         ///< by short filters: interpolatory schemes, corner cutting, cubic B-spline
    LEAST_SQUARES = 1  ///< the best ones, for every scheme
  };

  ///@{
  /**
   * How many steps are undone; 0 to 30. Initial value: 1.
   */
  vtkSetClampMacro(Levels, int, 0, 30);
  vtkGetMacro(Levels, int);
  ///@}

  ///@{
  /**
   * One of ReverseMode. Initial value: LEAST_SQUARES.
   */
  vtkSetClampMacro(Mode, int, LOCAL, LEAST_SQUARES);
  vtkGetMacro(Mode, int);
  ///@}

  ///@{
  /**
   * Keep the details. Initial value: on.
   */
  vtkSetMacro(KeepDetails, vtkTypeBool);
  vtkGetMacro(KeepDetails, vtkTypeBool);
  vtkBooleanMacro(KeepDetails, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Details up to this size are dropped, and the others kept as float: smaller, but no longer
   * exact. Initial value: 0, which drops nothing.
   */
  vtkSetClampMacro(Threshold, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Threshold, double);
  ///@}

  ///@{
  /**
   * The output as what it is.
   */
  vtkImageData* GetOutput();
  vtkImageData* GetOutput(int port);
  ///@}

 protected:
  vtkAreteCoarsen();
  ~vtkAreteCoarsen() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Levels = 1;
  int Mode = LEAST_SQUARES;
  vtkTypeBool KeepDetails = 1;
  double Threshold = 0;

 private:
  vtkAreteCoarsen(const vtkAreteCoarsen&) = delete;
  void operator=(const vtkAreteCoarsen&) = delete;
};

#endif
