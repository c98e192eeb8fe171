/** Records the view as a video in a format that the browser supports. */
import { panelWords } from '../language/panels';
import type { Film } from '../view/view';
import { Failure } from '../failure';

/** Longest film, in seconds. */
export const LONGEST = 60;

/** Records until it is stopped or the longest duration is reached. */
export class Recording {
  /** The film; rejected if it could not be made. */
  readonly done: Promise<Blob>;
  readonly #recorder: MediaRecorder;

  /** @param passed is called every second with the seconds recorded. */
  constructor(film: Film, type: string, passed: (seconds: number) => void) {
    this.#recorder = recorderOf(film, type);
    const began = performance.now();
    const clock = setInterval(() => {
      const seconds = Math.round((performance.now() - began) / 1000);
      passed(seconds);
      if (seconds >= LONGEST) this.stop();
    }, 1000);
    this.done = this.#record(type).finally(() => {
      clearInterval(clock);
      film.end();
    });
  }

  stop(): void {
    if (this.#recorder.state !== 'inactive') this.#recorder.stop();
  }

  #record(type: string): Promise<Blob> {
    const pieces: Blob[] = [];
    return new Promise((resolve, reject) => {
      this.#recorder.ondataavailable = ({ data }) => pieces.push(data);
      this.#recorder.onstop = () => resolve(new Blob(pieces, { type }));
      this.#recorder.onerror = () => reject(new Failure('no_film', panelWords.recording.broken));
      this.#recorder.start();
    });
  }
}

function recorderOf(film: Film, mimeType: string): MediaRecorder {
  try {
    return new MediaRecorder(film.stream, { mimeType });
  } catch (cause) {
    film.end();
    throw new Failure('no_film', panelWords.recording.broken, { cause });
  }
}
