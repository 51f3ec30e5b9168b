// SPDX-License-Identifier: BSD-3-Clause
// osg_mirror: the scene in OpenSceneGraph with water from a camera that renders the mirrored scene
// into a texture, as a peer (see peer.py).
//
//   osg_mirror SCENE
//
// OpenSceneGraph has no water of its own: this is what a program writes with it, in its usual way.
// The mirrored view is reflect(z) times the user's, so that the picture of a point of the water is
// at the same pixel in both, and a clip plane keeps what is under water out of it. The mirrored
// camera is in the group of the sheet and is culled with it. The context is EGL's: no X server is
// needed.
#include <osg/ClipNode>
#include <osg/Geometry>
#include <osg/LightModel>
#include <osg/LightSource>
#include <osg/Material>
#include <osg/Program>
#include <osg/Switch>
#include <osg/Texture2D>
#include <osg/Version>
#include <osgDB/WriteFile>
#include <osgUtil/CullVisitor>
#include <osgViewer/Viewer>

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <chrono>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{
struct Settings
{
  std::string Terrain;
  std::map<std::string, std::vector<double>> Numbers;

  explicit Settings(const char* file)
  {
    std::ifstream lines(file);
    for (std::string line; std::getline(lines, line);)
    {
      std::istringstream words(line);
      std::string name;
      words >> name;
      if (name == "terrain")
      {
        std::getline(words >> std::ws, this->Terrain);
      }
      for (double number; words >> number;)
      {
        this->Numbers[name].push_back(number);
      }
    }
  }

  double Number(const char* name, size_t i = 0) const { return this->Numbers.at(name).at(i); }
  osg::Vec4 Vector(const char* name, double last) const
  {
    return osg::Vec4(this->Number(name), this->Number(name, 1), this->Number(name, 2), last);
  }
  int Width() const { return static_cast<int>(this->Number("size")); }
  int Height() const { return static_cast<int>(this->Number("size", 1)); }
};

void MakeContext(int width, int height)
{
  auto getDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
    eglGetProcAddress("eglGetPlatformDisplayEXT"));
  EGLDisplay display = getDisplay
    ? getDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)
    : eglGetDisplay(EGL_DEFAULT_DISPLAY);
  const EGLint wanted[] = { EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
    EGL_RED_SIZE, 8, EGL_GREEN_SIZE, 8, EGL_BLUE_SIZE, 8, EGL_DEPTH_SIZE, 24, EGL_NONE };
  const EGLint size[] = { EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE };
  EGLConfig config;
  EGLint count = 0;
  if (!eglInitialize(display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API) ||
    !eglChooseConfig(display, wanted, &config, 1, &count) || count < 1)
  {
    throw std::runtime_error("EGL has no OpenGL pbuffer");
  }
  EGLSurface surface = eglCreatePbufferSurface(display, config, size);
  EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
  if (!eglMakeCurrent(display, surface, surface, context))
  {
    throw std::runtime_error("EGL cannot make its context current");
  }
}

// The layout that scene.py writes, see there.
osg::ref_ptr<osg::Geometry> ReadTerrain(const std::string& name)
{
  std::ifstream file(name, std::ios::binary);
  size_t pointCount = 0, triangleCount = 0;
  for (std::string line; std::getline(file, line) && line != "end_header";)
  {
    std::istringstream words(line);
    std::string element, what;
    words >> element >> what;
    if (element == "element")
    {
      words >> (what == "vertex" ? pointCount : triangleCount);
    }
  }
  osg::ref_ptr<osg::Vec3Array> points = new osg::Vec3Array(pointCount);
  osg::ref_ptr<osg::Vec3Array> normals =
    new osg::Vec3Array(osg::Array::BIND_PER_VERTEX, pointCount);
  osg::ref_ptr<osg::Vec4ubArray> colors =
    new osg::Vec4ubArray(osg::Array::BIND_PER_VERTEX, pointCount);
  colors->setNormalize(true);
  for (size_t i = 0; i < pointCount; ++i)
  {
    char bytes[27];
    file.read(bytes, sizeof bytes);
    std::memcpy((*points)[i].ptr(), bytes, 12);
    std::memcpy((*normals)[i].ptr(), bytes + 12, 12);
    std::memcpy((*colors)[i].ptr(), bytes + 24, 3);
    (*colors)[i].a() = 255;
  }
  osg::ref_ptr<osg::DrawElementsUInt> triangles = new osg::DrawElementsUInt(GL_TRIANGLES);
  triangles->reserve(3 * triangleCount);
  for (size_t i = 0; i < triangleCount; ++i)
  {
    char bytes[13];
    file.read(bytes, sizeof bytes);
    uint32_t corners[3];
    std::memcpy(corners, bytes + 1, 12);
    triangles->insert(triangles->end(), corners, corners + 3);
  }
  if (!file || triangles->empty())
  {
    throw std::runtime_error(name + ": no terrain");
  }
  osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
  geometry->setUseDisplayList(false);
  geometry->setUseVertexBufferObjects(true);
  geometry->setVertexArray(points);
  geometry->setNormalArray(normals);
  geometry->setColorArray(colors);
  geometry->addPrimitiveSet(triangles);
  return geometry;
}

// The ground under its sun.
osg::ref_ptr<osg::Group> MakeGround(const Settings& settings)
{
  osg::ref_ptr<osg::LightSource> sun = new osg::LightSource;
  sun->getLight()->setPosition(settings.Vector("to_sun", 0.0));
  sun->getLight()->setDiffuse(settings.Vector("sun_color", 1.0) * settings.Number("diffuse"));
  sun->getLight()->setAmbient(osg::Vec4(0.0, 0.0, 0.0, 1.0));
  sun->getLight()->setSpecular(osg::Vec4(0.0, 0.0, 0.0, 1.0));
  osg::ref_ptr<osg::LightModel> model = new osg::LightModel;
  const double ambient = settings.Number("ambient");
  model->setAmbientIntensity(osg::Vec4(ambient, ambient, ambient, 1.0));
  osg::ref_ptr<osg::Material> material = new osg::Material;
  material->setColorMode(osg::Material::AMBIENT_AND_DIFFUSE);

  osg::ref_ptr<osg::Group> ground = new osg::Group;
  osg::StateSet* state = ground->getOrCreateStateSet();
  state->setAttributeAndModes(model);
  state->setAttributeAndModes(material);
  state->setMode(GL_LIGHTING, osg::StateAttribute::ON);
  state->setMode(GL_LIGHT0, osg::StateAttribute::ON);
  ground->addChild(sun);
  ground->addChild(ReadTerrain(settings.Terrain));
  return ground;
}

const char* const VERTEX_SHADER = R"(
varying vec3 toEye;
varying vec3 up;
void main()
{
  toEye = -vec3(gl_ModelViewMatrix * gl_Vertex);
  up = gl_NormalMatrix * vec3(0.0, 0.0, 1.0);
  gl_Position = ftransform();
})";

// Schlick's Fresnel over the colour of deep water.
const char* const FRAGMENT_SHADER = R"(
uniform sampler2D mirrored;
uniform vec2 pixels;
varying vec3 toEye;
varying vec3 up;
void main()
{
  float facing = max(dot(normalize(toEye), normalize(up)), 0.0);
  float reflectance = 0.02 + 0.98 * pow(1.0 - facing, 5.0);
  vec3 reflected = texture2D(mirrored, gl_FragCoord.xy / pixels).rgb;
  gl_FragColor = vec4(mix(vec3(0.02, 0.07, 0.10), reflected, reflectance), 1.0);
})";

osg::ref_ptr<osg::Geometry> MakeSheet(const Settings& settings, osg::Texture2D* mirrored)
{
  const osg::Vec3 corner(settings.Number("sheet", 0), settings.Number("sheet", 2), 0.0);
  const osg::Vec3 east(settings.Number("sheet", 1) - corner.x(), 0.0, 0.0);
  const osg::Vec3 north(0.0, settings.Number("sheet", 3) - corner.y(), 0.0);
  osg::ref_ptr<osg::Geometry> sheet = osg::createTexturedQuadGeometry(corner, east, north);
  osg::ref_ptr<osg::Program> program = new osg::Program;
  program->addShader(new osg::Shader(osg::Shader::VERTEX, VERTEX_SHADER));
  program->addShader(new osg::Shader(osg::Shader::FRAGMENT, FRAGMENT_SHADER));
  osg::StateSet* state = sheet->getOrCreateStateSet();
  state->setAttributeAndModes(program);
  state->setTextureAttributeAndModes(0, mirrored);
  state->addUniform(new osg::Uniform("mirrored", 0));
  state->addUniform(new osg::Uniform("pixels", osg::Vec2(settings.Width(), settings.Height())));
  return sheet;
}

// Draws a node when its box is in view. The library's own test does not apply: a group with a light
// or a camera in it is never culled.
class WhenInView : public osg::NodeCallback
{
public:
  explicit WhenInView(const osg::BoundingBox& box)
    : Box(box)
  {
  }
  void operator()(osg::Node* node, osg::NodeVisitor* visitor) override
  {
    osgUtil::CullVisitor* cull = visitor->asCullVisitor();
    if (!cull || !cull->isCulled(this->Box))
    {
      this->traverse(node, visitor);
    }
  }

private:
  const osg::BoundingBox Box;
};

osg::ref_ptr<osg::Camera> MakeMirroredCamera(
  const Settings& settings, osg::Node* ground, osg::Texture2D* mirrored)
{
  osg::ref_ptr<osg::Camera> camera = new osg::Camera;
  camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
  camera->setRenderOrder(osg::Camera::PRE_RENDER);
  camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
  camera->attach(osg::Camera::COLOR_BUFFER, mirrored);
  camera->setViewport(0, 0, mirrored->getTextureWidth(), mirrored->getTextureHeight());
  camera->setClearColor(settings.Vector("sky", 1.0));
  camera->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
  osg::ref_ptr<osg::ClipNode> above = new osg::ClipNode;
  above->addClipPlane(new osg::ClipPlane(0, 0.0, 0.0, 1.0, 0.0));
  above->addChild(ground);
  camera->addChild(above);
  return camera;
}

// One viewer, one context; of the variants one is switched on.
class Peer
{
public:
  explicit Peer(const Settings& settings)
    : Scene(settings)
    , Variants(new osg::Switch)
  {
    MakeContext(settings.Width(), settings.Height());
    osg::ref_ptr<osg::Group> ground = MakeGround(settings);
    this->Add("plain", ground, 0.0);
    this->Add("mirror", ground, 1.0);
    this->Add("mirror-half", ground, 0.5);

    this->Viewer.setThreadingModel(osgViewer::Viewer::SingleThreaded);
    this->Viewer.setUpViewerAsEmbeddedInWindow(0, 0, settings.Width(), settings.Height());
    this->Viewer.setLightingMode(osg::View::NO_LIGHT);
    this->Viewer.setSceneData(this->Variants);
    osg::Camera* camera = this->Viewer.getCamera();
    camera->setClearColor(settings.Vector("sky", 1.0));
    camera->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    camera->setProjectionMatrixAsPerspective(settings.Number("view_angle"),
      settings.Number("size") / settings.Number("size", 1), settings.Number("clipping_range"),
      settings.Number("clipping_range", 1));
    this->Viewer.realize();
  }

  // Returns milliseconds, the drawing finished.
  double Render(const std::string& name, const osg::Vec3d& eye, const osg::Vec3d& target)
  {
    const auto begin = std::chrono::steady_clock::now();
    const size_t variant = this->Numbers.at(name);
    this->Variants->setSingleChildOn(variant);
    osg::Camera* camera = this->Viewer.getCamera();
    camera->setViewMatrixAsLookAt(eye, target, osg::Vec3d(0.0, 0.0, 1.0));
    if (osg::Camera* mirrored = this->Mirrored.at(variant))
    {
      mirrored->setViewMatrix(osg::Matrix::scale(1.0, 1.0, -1.0) * camera->getViewMatrix());
      mirrored->setProjectionMatrix(camera->getProjectionMatrix());
    }
    this->Viewer.frame();
    glFinish();
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
    return took.count();
  }

  void Save(const std::string& file) const
  {
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->readPixels(0, 0, this->Scene.Width(), this->Scene.Height(), GL_RGB, GL_UNSIGNED_BYTE);
    osgDB::writeImageFile(*image, file);
  }

private:
  void Add(const std::string& name, osg::Group* ground, double textureScale)
  {
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    osg::ref_ptr<osg::Camera> camera;
    scene->addChild(ground);
    if (textureScale > 0.0)
    {
      osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D;
      texture->setTextureSize(static_cast<int>(textureScale * this->Scene.Width()),
        static_cast<int>(textureScale * this->Scene.Height()));
      texture->setInternalFormat(GL_RGBA8);
      texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR);
      texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
      texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
      camera = MakeMirroredCamera(this->Scene, ground, texture);
      osg::ref_ptr<osg::Group> water = new osg::Group;
      water->addChild(camera);
      osg::ref_ptr<osg::Geometry> sheet = MakeSheet(this->Scene, texture);
      water->addChild(sheet);
      water->setCullCallback(new WhenInView(sheet->getBoundingBox()));
      scene->addChild(water);
    }
    this->Numbers[name] = this->Mirrored.size();
    this->Mirrored.push_back(camera);
    this->Variants->addChild(scene);
  }

  const Settings& Scene;
  osgViewer::Viewer Viewer;
  osg::ref_ptr<osg::Switch> Variants;
  std::map<std::string, size_t> Numbers;
  std::vector<osg::ref_ptr<osg::Camera>> Mirrored;
};

void Serve(Peer& peer)
{
  for (std::string line; std::getline(std::cin, line);)
  {
    std::istringstream words(line);
    std::string what, variant, file;
    osg::Vec3d eye, target;
    words >> what >> variant >> eye.x() >> eye.y() >> eye.z() >> target.x() >> target.y() >>
      target.z() >> file;
    const double took = peer.Render(variant, eye, target);
    if (what == "picture")
    {
      peer.Save(file);
      std::cout << "> done" << std::endl;
    }
    else
    {
      std::cout << "> " << took << std::endl;
    }
  }
}
}

int main(int argc, char** argv)
{
  try
  {
    const Settings settings(argc > 1 ? argv[1] : "");
    Peer peer(settings);
    std::cout << R"(> {"variants": ["plain", "mirror", "mirror-half"], "program": "OpenSceneGraph )"
              << osgGetVersion() << R"(", "renderer": ")" << glGetString(GL_RENDERER) << "\"}"
              << std::endl;
    Serve(peer);
  }
  catch (const std::exception& problem)
  {
    std::cerr << "osg_mirror: " << problem.what() << "\n";
    return 1;
  }
  return 0;
}
