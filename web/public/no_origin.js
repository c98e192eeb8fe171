// No module: without an origin a browser loads none.
if (origin === 'null') {
  document.getElementById('no-origin').hidden = false;
  const message = 'The sandbox of the frame needs allow-same-origin.';
  parent.postMessage({ chebnet: 1, event: 'error', error: { code: 'no_origin', message } }, '*');
}
