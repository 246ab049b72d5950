#pragma once
class vtkRenderWindow;
template <class T>
class vtkSmartPointer;

namespace seiche::render {

/// A window that draws in memory, ready to take renderers. All use of it stays on the thread that made it. Throws NoGl.
vtkSmartPointer<vtkRenderWindow> make_window(int width, int height);

}  // namespace seiche::render
