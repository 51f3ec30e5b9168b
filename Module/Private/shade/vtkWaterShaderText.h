// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterShaderText: puts lines into the sources of VTK's shaders.
#ifndef vtkWaterShaderText_h
#define vtkWaterShaderText_h

#include <string>

namespace vtkWaterShaderText
{
// Puts text before a tag, or after it, and keeps the tag for whoever comes next.
void InsertBefore(std::string& source, const std::string& tag, const std::string& text);
void InsertAfter(std::string& source, const std::string& tag, const std::string& text);

// Puts declarations before the tag that all of VTK's shaders have, or, where the user's own
// replacement took that, before main. Returns whether they are in.
bool InsertDeclarations(std::string& source, const std::string& text);

bool Declares(const std::string& source, const std::string& function);

// VTK's physically based shader of a single headlight has L = V = H written out; this gives it the
// terms of a directional light, which it declares anyway.
void MoveHeadlight(std::string& source);

// VTK's volumes have their headlight in a global for each volume; those after the first matrix,
// which is of all of them, when there are several. Light that they scatter has it in a line of its
// own.
void MoveHeadlightOfVolumes(std::string& source);
}

#endif
