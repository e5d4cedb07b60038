// SPDX-License-Identifier: MIT
/**
 * @class   vtkAreteRestore
 * @brief   put the image back together that vtkAreteCoarsen took apart
 *
 * The input is a coarse image with the field data "AreteDetails". Everything needed - scheme, mode,
 * boundary rules, where the image was - is kept there. The result has the extent, origin and
 * spacing of the original, its arrays in double, equal to a few rounding errors (with a threshold,
 * to about that).
 *
 * Coarse values that were changed on the way are refused unless SetEdited() allows them: then the
 * details of the original are added to the new shape.
 */
#ifndef vtkAreteRestore_h
#define vtkAreteRestore_h

#include "AreteFiltersModule.h"
#include "vtkImageAlgorithm.h"

class ARETEFILTERS_EXPORT vtkAreteRestore : public vtkImageAlgorithm {
 public:
  static vtkAreteRestore* New();
  vtkTypeMacro(vtkAreteRestore, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The coarse values were changed on purpose. Initial value: off.
   */
  vtkSetMacro(Edited, vtkTypeBool);
  vtkGetMacro(Edited, vtkTypeBool);
  vtkBooleanMacro(Edited, vtkTypeBool);
  ///@}

 protected:
  vtkAreteRestore();
  ~vtkAreteRestore() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  vtkTypeBool Edited = 0;

 private:
  vtkAreteRestore(const vtkAreteRestore&) = delete;
  void operator=(const vtkAreteRestore&) = delete;
};

#endif
