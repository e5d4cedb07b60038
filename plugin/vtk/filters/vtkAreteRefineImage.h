// SPDX-License-Identifier: MIT
/**
 * @class   vtkAreteRefineImage
 * @brief   refine the point data of an image by a subdivision scheme
 *
 * vtkAreteRefineImage takes an image with n points along i and j to one with about m^N n, where m
 * is the arity of the scheme and N the number of levels. All point arrays with numbers are refined,
 * every component by itself; cell data come from the parent cell. An image with several slices
 * along k is refined slice by slice.
 *
 * Input index i becomes index i m^N. Spacing is divided by m^N, and the origin moves by the shift
 * tau of the scheme, so that what is linear in space stays where it is; an image with a direction
 * matrix keeps it.
 *
 * float and integers of up to 16 bits give float, everything else double (see
 * SetOutputScalarType()).
 *
 * Points hidden by vtkGhostType (blanked ones) and values that are not finite are missing: a result
 * is missing unless the input cell it lies in has four points that are not. Such results are NaN,
 * and hidden if the input hides points. Missing values have no influence on others.
 *
 * The filter asks for exactly the input points that the wanted output needs. Any piece or extent
 * equals the same part of the whole to the last bit. Data that are already spread over processes
 * and cannot be asked for again (a per-process trivial producer) must hold that halo.
 */
#ifndef vtkAreteRefineImage_h
#define vtkAreteRefineImage_h

#include "vtkAreteFilter.h"

class ARETEFILTERS_EXPORT vtkAreteRefineImage : public vtkAreteFilter {
 public:
  static vtkAreteRefineImage* New();
  vtkTypeMacro(vtkAreteRefineImage, vtkAreteFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Where the refined points shall lie.
   */
  enum AlignmentMode {
    NODES = 0,  ///< between the outermost input points
    CELLS = 1   ///< centres of the input's pixels cut finer, outermost ones beyond the input points
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
   * One of AlignmentMode. Initial value: NODES.
   */
  vtkSetClampMacro(Alignment, int, NODES, CELLS);
  vtkGetMacro(Alignment, int);
  ///@}

  ///@{
  /**
   * Give values of the limit surface instead of those of level N. Schemes without a certified limit
   * are refused. Initial value: off.
   */
  vtkSetMacro(Limit, vtkTypeBool);
  vtkGetMacro(Limit, vtkTypeBool);
  vtkBooleanMacro(Limit, vtkTypeBool);
  ///@}

  ///@{
  /**
   * VTK_FLOAT or VTK_DOUBLE for all arrays, in which sums are taken too; 0: by the type of each.
   * Initial value: 0.
   */
  void SetOutputScalarType(int type);
  vtkGetMacro(OutputScalarType, int);
  ///@}

  ///@{
  /**
   * The output as what it is.
   */
  vtkImageData* GetOutput();
  vtkImageData* GetOutput(int port);
  ///@}

 protected:
  vtkAreteRefineImage();
  ~vtkAreteRefineImage() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Levels = 1;
  int Alignment = NODES;
  vtkTypeBool Limit = 0;
  int OutputScalarType = 0;

 private:
  vtkAreteRefineImage(const vtkAreteRefineImage&) = delete;
  void operator=(const vtkAreteRefineImage&) = delete;
};

#endif
