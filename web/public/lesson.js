// Talks to the embedded editor. What can be called is in web/src/embed/protocol.ts.
const NET = { recipe: 'dome:vertices=800' };
const frame = document.querySelector('iframe');
const measured = document.getElementById('measured');
const waiting = new Map();
let count = 0;

function call(name, ...args) {
  const id = ++count;
  frame.contentWindow.postMessage({ chebnet: 1, id, call: name, args }, location.origin);
  return new Promise((resolve, reject) => waiting.set(id, { resolve, reject }));
}

addEventListener('message', ({ source, data }) => {
  if (source !== frame.contentWindow || data?.chebnet !== 1) return;
  if (data.event === 'ready') void begin();
  else if (data.event === 'settled') show(data.stats);
  else if (waiting.has(data.id)) {
    const { resolve, reject } = waiting.get(data.id);
    waiting.delete(data.id);
    if (data.error) reject(new Error(data.error.message));
    else resolve(data.result);
  }
});

async function begin() {
  await call('on', 'settled');
  await call('open', NET);
  show(await call('stats'));
  for (const button of document.querySelectorAll('button')) button.disabled = false;
}

function show({ edges, maxDeviation, iterations }) {
  const worst = maxDeviation < 1e-12 ? 'below 1e-12' : maxDeviation.toExponential(1);
  measured.textContent = `The largest dL of its ${edges} edges is ${worst}, after ${iterations} iterations.`;
}

/** The last handle is the one to drag. */
async function moveCrown(up) {
  const { vertex, target: [x, y, z] } = (await call('handles')).at(-1);
  await call('move', vertex, [x, y, z + up]);
}

document.getElementById('push').addEventListener('click', () => void moveCrown(-0.4));
document.getElementById('lift').addEventListener('click', () => void moveCrown(0.4));
document.getElementById('again').addEventListener('click', () => void call('open', NET));
