// Detects whether WebGL uses a graphics card or a software renderer.

const kByProcessor = /swiftshader|llvmpipe|softpipe|software|basic render/i;

export const kGraphicsCard = (() => {
  const gl = document.createElement('canvas').getContext('webgl2');
  if (!gl) return false;
  const known = gl.getExtension('WEBGL_debug_renderer_info');
  const name = gl.getParameter(known ? known.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return !kByProcessor.test(name);
})();
