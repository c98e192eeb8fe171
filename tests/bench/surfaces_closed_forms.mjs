// Nets that are known in closed form, laid in WebAssembly and held against it.

/** A graph over a square of size 2, of n × n points. */
function graph(n, height) {
  const positions = new Float64Array(3 * n * n);
  const faceVertices = [];
  for (let j = 0; j < n; j++)
    for (let i = 0; i < n; i++) {
      const [x, y] = [(2 * i) / (n - 1) - 1, (2 * j) / (n - 1) - 1];
      positions.set([x, y, height(x, y)], 3 * (j * n + i));
      if (i > 0 && j > 0) faceVertices.push((j - 1) * n + i - 1, (j - 1) * n + i, j * n + i, j * n + i - 1);
    }
  return { positions, ...quads(faceVertices) };
}

function quads(faceVertices) {
  const faceStart = Int32Array.from({ length: faceVertices.length / 4 + 1 }, (_, face) => 4 * face);
  return { faceStart, faceVertices: Int32Array.from(faceVertices) };
}

/** Half an octahedron flattened to the square, blown up to the unit hemisphere. */
function hemisphere(n) {
  const mesh = graph(n, () => 0);
  for (let v = 0; v < n * n; v++) {
    const [u, w] = [mesh.positions[3 * v], mesh.positions[3 * v + 1]];
    const [x, y] = [(u - w) / 2, (u + w) / 2];
    const z = 1 - Math.abs(x) - Math.abs(y);
    const length = Math.hypot(x, y, z);
    mesh.positions.set([x / length, y / length, z / length], 3 * v);
  }
  return mesh;
}

/** Between the families on the unit sphere, at the distances u and v along arms at right angles: of z = u v,
 *  z ω″ + ω′ = −sin ω, by the midpoint rule from its series at 0. */
function angleOnSphere(z) {
  let at = 1e-4;
  let angle = Math.PI / 2 - at;
  let slope = -1;
  const steps = 20000;
  const h = (z - at) / steps;
  for (let k = 0; k < steps; k++) {
    const halfAngle = angle + (h / 2) * slope;
    const halfSlope = slope + ((h / 2) * (-Math.sin(angle) - slope)) / at;
    angle += h * halfSlope;
    slope += (h * (-Math.sin(halfAngle) - halfSlope)) / (at + h / 2);
    at += h;
  }
  return angle;
}

/** By how much the angles of cells on the diagonal are off, up to a distance along the arms. */
function errorOnSphere(surface, length, reach) {
  const { mesh, places } = surface.drape({ seed: [0, 0, 1], direction: [1, 0, 0], length, smallestAngle: 0.2 });
  const at = new Map();
  for (let v = 0; 2 * v < places.length; v++)
    at.set(`${places[2 * v]},${places[2 * v + 1]}`, mesh.positions.subarray(3 * v, 3 * v + 3));
  const arc = 2 * Math.asin(length / 2);
  let largest = 0;
  for (let k = 0; (k + 1) * arc <= reach; k++) {
    const [x, a, b] = [`${k},${k}`, `${k + 1},${k}`, `${k},${k + 1}`].map((place) => at.get(place));
    const cosine = [0, 1, 2].reduce((sum, i) => sum + (a[i] - x[i]) * (b[i] - x[i]), 0) / length ** 2;
    largest = Math.max(largest, Math.abs(Math.acos(cosine) - angleOnSphere(((k + 0.5) * arc) ** 2)));
  }
  return largest;
}

const HYPAR = (x, y) => 0.5 * x * y;

/** How far vertices laid on n × n points of the hypar are from the hypar itself, at most and in edge lengths. */
function errorOnHypar(chebnet, n) {
  const length = 0.05;
  const surface = chebnet.openSurface(graph(n, HYPAR));
  const { mesh } = surface.drape({ seed: [0, 0, 0], direction: [1, 0, 0], length, border: 'inside' });
  surface.dispose();
  let largest = 0;
  for (let i = 0; i < mesh.positions.length; i += 3) {
    const [x, y, z] = mesh.positions.subarray(i, i + 3);
    largest = Math.max(largest, Math.abs(z - HYPAR(x, y)));
  }
  return largest / length;
}

export function closedForms(chebnet) {
  const [coarse, fine] = [61, 121].map((n) => errorOnHypar(chebnet, n));
  const sphere = chebnet.openSurface(hemisphere(501));
  const errors = [0.2, 0.1].map((length) => errorOnSphere(sphere, length, 0.9));
  const sheared = [0.1, 0.05].map((length) => {
    const { mesh } = sphere.drape({ seed: [0, 0, 1], direction: [1, 0, 0], length });
    return sphere.measure(mesh).muchSheared;
  });
  sphere.dispose();
  return [
    {
      of: 'hypar of 61 × 61 points: largest distance of vertices from the hypar itself, L',
      is: coarse.toExponential(2),
      expected: 'that of the triangles',
    },
    {
      of: 'the same on 121 × 121, times less',
      is: (coarse / fine).toFixed(2),
      expected: '4: the net is on the triangles',
    },
    { of: 'sphere (sine-Gordon): error of angles at L = 0.2', is: errors[0].toExponential(2), expected: '' },
    { of: 'the same at L = 0.1, times less', is: (errors[0] / errors[1]).toFixed(2), expected: '4 (second order)' },
    { of: 'hemisphere: cells sheared over 30° at L = 0.1', is: `${(100 * sheared[0]).toFixed(1)} %`, expected: '' },
    { of: 'the same at L = 0.05', is: `${(100 * sheared[1]).toFixed(1)} %`, expected: 'the same: shear has no scale' },
  ];
}
