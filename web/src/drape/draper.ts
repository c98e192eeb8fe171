/** Lays nets on one surface: the draping worker's part without the worker. */
import type { Chebnet, Drape, Point, Surface, SurfacePlace } from '../../../wasm/chebnet';
import { codeOf, messageOf } from '../failure';
import { withEditor } from '../files/file_report';
import { describe } from '../worker/opened_net';
import type { DrapedNet, DrapeRequest, DrapeResponse, SurfaceSource, Wish } from './drape_protocol';
import { SUGGESTED_CELLS } from './cells';
import { laidInto } from './seed';

export class Draper {
  readonly #core: Chebnet;
  readonly #post: (response: DrapeResponse) => void;
  #surface: Surface | null = null;
  #drape: Drape | null = null;

  constructor(core: Chebnet, post: (response: DrapeResponse) => void) {
    this.#core = core;
    this.#post = post;
  }

  handle(request: DrapeRequest): void {
    try {
      this.#post(this.#answer(request));
    } catch (error) {
      this.#post({ type: 'error', code: codeOf(error), message: messageOf(error) });
    }
  }

  #answer(request: DrapeRequest): DrapeResponse {
    if (request.type === 'open') return this.#open(request.source);
    if (this.#surface === null) throw new Error('no surface is open');
    if (request.type === 'drape') return this.#lay(this.#surface, request.wish);
    if (this.#drape === null) throw new Error('no net has been laid');
    return { type: 'measured', report: this.#surface.measure(this.#drape.mesh) };
  }

  #open(source: SurfaceSource): DrapeResponse {
    const surface = 'own' in source ? this.#core.ownSurface(source.own) : this.#core.openSurface(source.mesh);
    this.#surface?.dispose();
    this.#surface = surface;
    this.#drape = null;
    const { positions, normals, triangles } = surface;
    return {
      type: 'opened',
      surface: { positions, normals, triangles, report: surface.describe() },
      suggested: surface.suggest(SUGGESTED_CELLS),
    };
  }

  #lay(surface: Surface, wish: Wish): DrapeResponse {
    const place = placeOf(surface, wish.seed);
    if (place === null) return { type: 'missed' };
    const direction = laidInto(wish.direction, place.normal);
    const start = performance.now();
    const drape = surface.drape({ ...wish, seed: place.position, direction });
    const milliseconds = performance.now() - start;
    this.#drape = drape;
    return { type: 'draped', seed: { ...place, direction }, milliseconds, ...this.#shown(drape) };
  }

  #shown({ mesh, places, locked, met }: Drape): Omit<DrapedNet, 'seed' | 'milliseconds'> {
    const shown = withEditor(this.#core, mesh, (editor) => ({ net: describe(editor), fields: editor.fields() }));
    return { ...shown, places, locked, met };
  }
}

function placeOf(surface: Surface, seed: Wish['seed']): SurfacePlace | null {
  return 'origin' in seed ? surface.hit(seed.origin, seed.direction) : surface.nearest(seed satisfies Point);
}
