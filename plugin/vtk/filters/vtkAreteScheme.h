// SPDX-License-Identifier: MIT
/**
 * @class   vtkAreteScheme
 * @brief   a subdivision scheme put together from a family and its parameters
 *
 * What a property panel needs: a family of the catalogue by name and its parameters one by one.
 * GetText() gives the text form that every filter reads, such as "four-point:omega=1/16".
 * Parameters that are not set take their defaults.
 *
 * Parameters given as floating point stand for the simplest fraction that rounds to them, so that
 * 0.1 and 1.0 / 11 mean the same as 1/10 and 1/11 in the text form.
 *
 * Nothing is checked here; a filter that uses the scheme reports what is wrong with it.
 */
#ifndef vtkAreteScheme_h
#define vtkAreteScheme_h

#include <map>
#include <string>

#include "AreteFiltersModule.h"
#include "vtkObject.h"

class ARETEFILTERS_EXPORT vtkAreteScheme : public vtkObject {
 public:
  static vtkAreteScheme* New();
  vtkTypeMacro(vtkAreteScheme, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The name of a family of the catalogue. Initial value: "gentle". Setting another family forgets
   * the parameters.
   */
  void SetFamily(const char* name);
  const char* GetFamily() { return this->Family.c_str(); }
  ///@}

  /**
   * Chooses the value of one parameter of the family.
   */
  void SetParameter(const char* name, double value);

  /**
   * The same as text: "7/32", "0.21875", or for lists "-1/16;0;9/16". An empty text takes the
   * choice back.
   */
  void SetParameterText(const char* name, const char* value);

  /**
   * Takes family and parameters from the text form `family:key=value,key=value`.
   */
  void SetText(const char* text);

  /**
   * The text form.
   */
  const char* GetText();

  ///@{
  /**
   * The families of the catalogue, in its order; a null pointer beyond its ends.
   */
  static int GetNumberOfFamilies();
  static const char* GetFamilyName(int index);
  static const char* GetFamilySummary(int index);
  ///@}

 protected:
  vtkAreteScheme();
  ~vtkAreteScheme() override;

 private:
  vtkAreteScheme(const vtkAreteScheme&) = delete;
  void operator=(const vtkAreteScheme&) = delete;

  std::string Family;
  std::map<std::string, std::string> Parameters;
  std::string Text;
};

#endif
