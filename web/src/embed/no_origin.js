// What no_origin_inline.ts puts into the document.
if (origin === 'null') {
  document.getElementById('no-origin').hidden = false;
  const message = 'The sandbox of the frame needs allow-same-origin.';
  parent.postMessage({ chebnet: 1, event: 'error', error: { code: 'no_origin', message } }, '*');
}
