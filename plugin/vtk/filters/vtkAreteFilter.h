// SPDX-License-Identifier: MIT
/**
 * @class   vtkAreteFilter
 * @brief   what the filters of this module have in common: scheme, boundary rules, threads
 *
 * A scheme is given in its text form, `name` or `name:key=value,key=value` with decimal or rational
 * values: "gentle", "four-point:omega=1/16", "b-spline:degree=3",
 * "mask:arity=2,first=-1,coefficients=1/2;1;1/2". The families are those of vtkAreteScheme.
 *
 * Along x (VTK's i) and y (j) the scheme and the boundary rule may differ. VTK's j usually runs
 * north, the rows of a raster run south: a scheme that is not symmetric sees the other side.
 *
 * Results do not depend on the number of threads, nor on the pieces they are asked for in, to the
 * last bit.
 */
#ifndef vtkAreteFilter_h
#define vtkAreteFilter_h

#include "AreteFiltersModule.h"
#include "vtkDataSetAlgorithm.h"

class vtkAreteScheme;

class ARETEFILTERS_EXPORT vtkAreteFilter : public vtkDataSetAlgorithm {
 public:
  vtkTypeMacro(vtkAreteFilter, vtkDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * How an axis is continued beyond its ends.
   */
  enum BoundaryRule {
    EXTRAPOLATE = 0,  ///< linearly: planes stay planes
    CLAMP = 1,        ///< the end sample is repeated
    REFLECT = 2,      ///< mirrored at the end sample
    PERIODIC = 3,     ///< the axis is closed: n samples a turn, the first not repeated at the end
    NONE = 4          ///< not at all: the result shrinks to what can be computed
  };

  ///@{
  /**
   * The scheme along x, and along y unless SchemeY is set, as text. Initial value: "gentle".
   */
  vtkSetStringMacro(Scheme);
  vtkGetStringMacro(Scheme);
  ///@}

  ///@{
  /**
   * Another scheme along y; null or empty: the same. Initial value: null.
   */
  vtkSetStringMacro(SchemeY);
  vtkGetStringMacro(SchemeY);
  ///@}

  ///@{
  /**
   * The scheme as an object whose parameters a panel can change; it goes before the text of Scheme.
   * Initial value: null.
   */
  virtual void SetSchemeObject(vtkAreteScheme*);
  vtkGetObjectMacro(SchemeObject, vtkAreteScheme);
  ///@}

  ///@{
  /**
   * The boundary rules, one of BoundaryRule. Initial value: EXTRAPOLATE.
   */
  vtkSetClampMacro(BoundaryX, int, EXTRAPOLATE, NONE);
  vtkGetMacro(BoundaryX, int);
  vtkSetClampMacro(BoundaryY, int, EXTRAPOLATE, NONE);
  vtkGetMacro(BoundaryY, int);
  ///@}

  /**
   * Sets the rule along both axes.
   */
  void SetBoundary(int rule);

  ///@{
  /**
   * How many threads to use; 0: as many as the machine has. Initial value: 0.
   */
  vtkSetClampMacro(NumberOfThreads, int, 0, 4096);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  /**
   * The text of the scheme in use along x: that of SchemeObject if there is one.
   */
  const char* GetSchemeInUse();

  vtkMTimeType GetMTime() override;

 protected:
  vtkAreteFilter();
  ~vtkAreteFilter() override;

  char* Scheme = nullptr;
  char* SchemeY = nullptr;
  vtkAreteScheme* SchemeObject = nullptr;
  int BoundaryX = EXTRAPOLATE;
  int BoundaryY = EXTRAPOLATE;
  int NumberOfThreads = 0;

 private:
  vtkAreteFilter(const vtkAreteFilter&) = delete;
  void operator=(const vtkAreteFilter&) = delete;
};

#endif
