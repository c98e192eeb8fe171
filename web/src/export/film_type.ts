/** The formats in which a browser may record the view as a video. */

/** In order of preference. */
const TYPES = ['video/webm;codecs=vp9', 'video/webm', 'video/mp4'] as const;

/** The first type that this browser supports; null: none. */
export function filmType(): string | null {
  if (typeof MediaRecorder === 'undefined' || !('captureStream' in HTMLCanvasElement.prototype)) return null;
  return TYPES.find((type) => MediaRecorder.isTypeSupported(type)) ?? null;
}

export function filmExtension(type: string): 'webm' | 'mp4' {
  return type.startsWith('video/mp4') ? 'mp4' : 'webm';
}
