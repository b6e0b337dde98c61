// node vtkjs.mjs NODE_MODULES FOLDER: vtk.js's functions, filled with each FOLDER/*.vtkjs.json as an application does it,
// are those of the preset beside it, FOLDER/*.preset.json, at 1000 values.
import fs from 'fs';
import path from 'path';
import { pathToFileURL } from 'url';

const [modules, folder] = process.argv.slice(2);
const load = async (name) =>
  (await import(pathToFileURL(path.join(modules, '@kitware/vtk.js', name)).href)).default;
const vtkPiecewiseFunction = await load('Common/DataModel/PiecewiseFunction.js');
const vtkColorTransferFunction = await load('Rendering/Core/ColorTransferFunction.js');

const rgba = (p) => [...p.color, p.opacity];
function evaluate(points, value) {
  if (value < points[0].value) return rgba(points[0]);
  for (let i = 1; i < points.length; ++i) {
    const [a, b] = [points[i - 1], points[i]];
    if (a.value <= value && value < b.value) {
      const s = (value - a.value) / (b.value - a.value);
      return rgba(a).map((x, k) => x + (rgba(b)[k] - x) * s);
    }
  }
  return rgba(points[points.length - 1]);
}
// A step's points are drawn apart by some 2e-6 of the size of their values: that, along the line through the value
function tolerance(points, size, value) {
  for (let i = 1; i < points.length; ++i) {
    const [a, b] = [points[i - 1], points[i]];
    if (a.value <= value && value < b.value) {
      const rise = Math.max(...rgba(a).map((x, k) => Math.abs(x - rgba(b)[k])));
      return 1e-9 + (3e-6 * size * rise) / (b.value - a.value);
    }
  }
  return 1e-9;
}

let bad = 0;
const files = fs.readdirSync(folder).filter((f) => f.endsWith('.vtkjs.json'));
for (const file of files) {
  const map = JSON.parse(fs.readFileSync(path.join(folder, file)));
  const preset = JSON.parse(fs.readFileSync(path.join(folder, file.replace('.vtkjs.json', '.preset.json'))));
  const points = preset.transfer_function.points;
  const colors = vtkColorTransferFunction.newInstance();
  const opacities = vtkPiecewiseFunction.newInstance();
  for (let i = 0; i < map.RGBPoints.length; i += 4) colors.addRGBPoint(...map.RGBPoints.slice(i, i + 4));
  for (let i = 0; i < map.OpacityPoints.length; i += 2) opacities.addPoint(...map.OpacityPoints.slice(i, i + 2));
  const [low, high] = [points[0].value, points[points.length - 1].value];
  const size = Math.max(high - low, Math.abs(low), Math.abs(high));
  let worst = 0;
  for (let i = 0, tried = 0; tried < 1000; ++i) {
    const place = (i * 0.6180339887498949) % 1;
    const value = low + (1.2 * place - 0.1) * (high - low);
    if (points.some((p) => Math.abs(p.value - value) <= 1e-5 * size)) continue;
    ++tried;
    const color = [0, 0, 0];
    colors.getColor(value, color);
    const found = [...color, opacities.getValue(value)];
    const off = Math.max(...evaluate(points, value).map((x, k) => Math.abs(x - found[k])));
    worst = Math.max(worst, off / tolerance(points, size, value));
  }
  const good = worst <= 1 && opacities.getSize() === points.length;
  bad += good ? 0 : 1;
  console.log(`${good ? 'ok    ' : 'FAILED'} ${file}: off by ${worst.toPrecision(2)} of what it may be`);
}
process.exit(bad === 0 && files.length > 0 ? 0 : 1);
