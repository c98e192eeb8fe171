// Asks for the words of the visitor's language before the modules that want them are there. The choice is that of
// src/language/choice.ts; where it were another, the words would only come a little later.
let wanted = navigator.language ?? '';
try {
  wanted = localStorage.getItem('chebnet.language') ?? wanted;
} catch {
  // Storage is switched off.
}
const link = document.createElement('link');
link.rel = 'modulepreload';
link.href = document.currentScript.dataset[wanted.toLowerCase().startsWith('zh') ? 'zh' : 'en'];
document.head.append(link);
