// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVWaterRepresentation
 * @brief   shows water in a render view of ParaView
 *
 * Owns a vtkWaterActor and adds it to the view's renderer. The input is that of
 * vtkPVWaterSheetSource, which says where the sheet lies; a subclass shows other data. The waves'
 * time is the view's time. With several ranks that render one picture, the ranks' waters are joined
 * (vtkWaterReflectionPass::SetController).
 *
 * The setters keep what they are given. Before the next frame all of it is applied to a new
 * vtkWaterProperty in one order: the preset, then what replaces parts of it. The order of the calls
 * does not matter. vtkWaterProperty reports values out of range, once per change.
 *
 * @sa vtkWaterActor vtkWaterProperty vtkPVWaterSurfaceRepresentation
 */
#ifndef vtkPVWaterRepresentation_h
#define vtkPVWaterRepresentation_h

#include "vtkNew.h" // for members
#include "vtkPVDataRepresentation.h"
#include "vtkWaterRepresentationsModule.h" // for the export macro
#include "vtkWeakPointer.h"                // for members

#include <string> // for members
#include <vector> // for members

class vtkCallbackCommand;
class vtkDataObject;
class vtkMultiProcessController;
class vtkOrderedCompositingHelper;
class vtkPVRenderView;
class vtkPVSession;
class vtkPolyData;
class vtkRenderer;
class vtkWaterActor;
class vtkWaterProperty;

class VTKWATERREPRESENTATIONS_EXPORT vtkPVWaterRepresentation : public vtkPVDataRepresentation
{
public:
  static vtkPVWaterRepresentation* New();
  vtkTypeMacro(vtkPVWaterRepresentation, vtkPVDataRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The water's look and waves to begin with: a name that vtkWaterProperty::SetPreset accepts, or
   * "none", the default: calm water with the colour of a clear lake.
   */
  void SetPreset(const char* name) { this->Set(this->Settings.Preset, name ? name : "none"); }
  ///@}

  enum WaveModes
  {
    WAVES_OF_PRESET = 0,
    CALM = 1,
    WIND_SEA = 2, ///< WindSpeed, WindDirection, Fetch, SeaSeed
    SINES = 3     ///< AddSineWave
  };

  ///@{
  /**
   * Waves: those of the preset, none, a wind sea, or sines (WaveModes). Default is WAVES_OF_PRESET.
   */
  void SetWaveMode(int mode) { this->Set(this->Settings.WaveMode, mode); }
  void SetWindSpeed(double speed) { this->Set(this->Settings.WindSpeed, speed); }
  void SetWindDirection(double degrees) { this->Set(this->Settings.WindDirection, degrees); }
  void SetFetch(double metres) { this->Set(this->Settings.Fetch, metres); }
  void SetSeaSeed(int seed) { this->Set(this->Settings.SeaSeed, seed); }
  void SetWhitecaps(bool isOn) { this->Set(this->Settings.Whitecaps, isOn); }
  void SetWaveGeometry(bool isOn) { this->Set(this->Settings.WaveGeometry, isOn); }
  void AddSineWave(double amplitude, double wavelength, double direction);
  void RemoveAllSineWaves();
  ///@}

  enum Choices
  {
    OF_PRESET = 0,
    OFF = 1,
    ON = 2
  };

  ///@{
  /**
   * What is seen through the surface: see vtkWaterProperty. Refraction is one of Choices; WaterType
   * is one of Jerlov's types, or "none"; the colour is used if UseDeepColor is on.
   */
  void SetRefraction(int choice) { this->Set(this->Settings.Refraction, choice); }
  void SetWaterType(const char* name) { this->Set(this->Settings.WaterType, name ? name : "none"); }
  void SetUseDeepColor(bool isOn) { this->Set(this->Settings.UseDeepColor, isOn); }
  void SetDeepColor(double red, double green, double blue);
  void SetOpacity(double opacity) { this->Set(this->Settings.Opacity, opacity); }
  void SetCaustics(double strength) { this->Set(this->Settings.Caustics, strength); }
  void SetLightShafts(double share) { this->Set(this->Settings.LightShafts, share); }
  void SetDomePortRadius(double metres) { this->Set(this->Settings.DomePortRadius, metres); }
  void SetShoreSoftness(double metres) { this->Set(this->Settings.ShoreSoftness, metres); }
  void SetFoamDepth(double metres) { this->Set(this->Settings.FoamDepth, metres); }
  void SetFoamStretch(double stretch) { this->Set(this->Settings.FoamStretch, stretch); }
  void SetFoamColor(double red, double green, double blue);
  void SetGlitter(bool isOn) { this->Set(this->Settings.Glitter, isOn); }
  void SetShadows(bool isOn) { this->Set(this->Settings.Shadows, isOn); }
  void SetSceneReflection(bool isOn) { this->Set(this->Settings.SceneReflection, isOn); }
  void SetMetresPerUnit(double metres) { this->Set(this->Settings.MetresPerUnit, metres); }
  ///@}

  ///@{
  /**
   * Quality: a name that vtkWaterProperty::SetRayTraceQuality accepts, and
   * vtkWaterReflectionPass::SetTextureScale.
   */
  void SetQuality(const char* name) { this->Set(this->Settings.Quality, name ? name : "default"); }
  void SetTextureScale(double scale) { this->Set(this->Settings.TextureScale, scale); }
  ///@}

  ///@{
  /**
   * The waves' time in seconds is TimeScale times the view's time plus TimeShift. Defaults are 1
   * and 0.
   */
  void SetTimeScale(double secondsPerUnit) { this->Set(this->Settings.TimeScale, secondsPerUnit); }
  void SetTimeShift(double seconds) { this->Set(this->Settings.TimeShift, seconds); }
  ///@}

  ///@{
  /**
   * Of the last frame that this process has rendered: how many mirrored views there have been so
   * far, pixels that the ranks have sent each other for the last one, the decision, and the error
   * in words, or "".
   */
  int GetNumberOfReflectionRenders();
  int GetNumberOfPixelsJoined();
  const char* GetDecision();
  const char* GetLastError();
  double GetWaveTime();
  ///@}

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;
  void SetVisibility(bool isVisible) override;

protected:
  vtkPVWaterRepresentation();
  ~vtkPVWaterRepresentation() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

  // Keeps the input, or nullptr, as the piece of this rank.
  virtual void Keep(vtkDataObject* input, vtkPolyData* piece);
  // Hands what the representation shows over to the view, which delivers it where it is rendered.
  virtual void Offer(vtkInformation* inInfo);
  // The same for frames of lower detail.
  virtual void OfferCoarse(vtkInformation*) {}
  // Puts what was delivered into the actor. ranks: those that render this frame together, or
  // nullptr.
  virtual void Take(vtkInformation* inInfo, vtkMultiProcessController* ranks);
  // Has every rank the whole surface? Else each has its part of it, where its part of the data is.
  virtual bool IsWhole() const { return true; }
  // Applies what a subclass has of a look.
  virtual void ApplyMore(vtkWaterProperty*) {}
  void ChangeLook();
  template <typename T, typename V>
  void Set(T& setting, const V& value)
  {
    if (setting != value)
    {
      setting = value;
      this->ChangeLook();
    }
  }

  vtkWaterActor* GetActor() const { return this->Actor; }
  vtkPolyData* GetPiece() const { return this->Piece; }

private:
  vtkPVWaterRepresentation(const vtkPVWaterRepresentation&) = delete;
  void operator=(const vtkPVWaterRepresentation&) = delete;

  struct Look
  {
    std::string Preset = "none";
    int WaveMode = WAVES_OF_PRESET;
    double WindSpeed = 5.0;
    double WindDirection = 0.0;
    double Fetch = 10000.0;
    int SeaSeed = 1;
    bool Whitecaps = false;
    bool WaveGeometry = false;
    std::vector<double> Sines; // amplitude, wavelength, direction
    int Refraction = OF_PRESET;
    std::string WaterType = "none";
    bool UseDeepColor = false;
    double DeepColor[3] = { 0.02, 0.08, 0.12 };
    double Opacity = 1.0;
    double Caustics = 0.0;
    double LightShafts = 0.0;
    double DomePortRadius = 0.0;
    double ShoreSoftness = 0.05;
    double FoamDepth = 0.0;
    double FoamStretch = 0.0;
    double FoamColor[3] = { 0.95, 0.97, 1.0 };
    bool Glitter = true;
    bool Shadows = false;
    bool SceneReflection = true;
    double MetresPerUnit = 1.0;
    std::string Quality = "default";
    double TextureScale = 1.0;
    double TimeScale = 1.0;
    double TimeShift = 0.0;
  };

  void ApplyLook();
  void ApplyWaves(vtkWaterProperty* look);
  void ApplyOptics(vtkWaterProperty* look);
  void PrepareRender(vtkPVRenderView* view, vtkInformation* inInfo);
  void FindFarthest(vtkRenderer* renderer);
  void FindRegion(int rank); // of the space; -1: there is none

  vtkWeakPointer<vtkPVSession> Session; // the one that this object was made for
  vtkNew<vtkWaterActor> Actor;
  vtkNew<vtkPolyData> Piece;
  vtkNew<vtkCallbackCommand> Starts;                  // of the view's renderer
  vtkNew<vtkOrderedCompositingHelper> ServersInOrder; // by their parts of the space
  bool AreServersInOrder = false;                     // in this frame
  Look Settings;
  bool IsLookNew = true;
};

#endif
