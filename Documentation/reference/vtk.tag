<?xml version='1.0' encoding='UTF-8' standalone='yes' ?>
<!-- The classes of VTK that ours stand on, for links into VTK's own documentation. -->
<tagfile>
  <compound kind="class"><name>vtkObject</name><filename>classvtkObject.html</filename></compound>
  <compound kind="class"><name>vtkActor</name><filename>classvtkActor.html</filename></compound>
  <compound kind="class"><name>vtkOpenGLActor</name><filename>classvtkOpenGLActor.html</filename><base>vtkActor</base></compound>
  <compound kind="class"><name>vtkOpenGLRenderPass</name><filename>classvtkOpenGLRenderPass.html</filename></compound>
  <compound kind="class"><name>vtkPlane</name><filename>classvtkPlane.html</filename></compound>
  <compound kind="class"><name>vtkRenderer</name><filename>classvtkRenderer.html</filename></compound>
  <compound kind="class"><name>vtkRenderPass</name><filename>classvtkRenderPass.html</filename></compound>
  <compound kind="class"><name>vtkRenderStepsPass</name><filename>classvtkRenderStepsPass.html</filename></compound>
  <compound kind="class"><name>vtkRenderWindow</name><filename>classvtkRenderWindow.html</filename></compound>
  <compound kind="class"><name>vtkTexture</name><filename>classvtkTexture.html</filename></compound>
  <compound kind="class"><name>vtkTextureObject</name><filename>classvtkTextureObject.html</filename></compound>
  <compound kind="class"><name>vtkMapper</name><filename>classvtkMapper.html</filename></compound>
</tagfile>
