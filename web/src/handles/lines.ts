/** Lines of vertices that a net is made of: its boundary loops and its net lines. */

export interface Faces {
  /** Face f is `faceVertices[faceStart[f]] … faceVertices[faceStart[f + 1] - 1]`. */
  faceStart: Int32Array;
  faceVertices: Int32Array;
}

/** Two neighbours of a vertex that share a face with it. */
type Corner = readonly [number, number];

export class Lines {
  readonly #corners = new Map<number, Corner[]>();

  constructor({ faceStart, faceVertices }: Faces) {
    for (let face = 0; face + 1 < faceStart.length; ++face) {
      const vertices = faceVertices.subarray(faceStart[face], faceStart[face + 1]);
      vertices.forEach((vertex, k) => {
        const corner: Corner = [vertices.at(k - 1)!, vertices[(k + 1) % vertices.length]!];
        const known = this.#corners.get(vertex);
        if (known) known.push(corner);
        else this.#corners.set(vertex, [corner]);
      });
    }
  }

  /** The boundary loop through a vertex, which comes first; empty if it lies inside. */
  boundary(vertex: number): number[] {
    const loop = new Set<number>();
    let next = this.#boundaryNeighbours(vertex).length > 0 ? vertex : undefined;
    while (next !== undefined) {
      loop.add(next);
      next = this.#boundaryNeighbours(next).find((each) => !loop.has(each));
    }
    return [...loop];
  }

  /** The net lines through a vertex, each from end to end; a closed one begins anywhere. A line goes straight on: a regular
   *  vertex has two of them; a singular one, where lines end, has one for each of its edges. */
  through(vertex: number): number[][] {
    const lines: number[][] = [];
    const walked = new Set<number>();
    for (const next of this.#neighbours(vertex)) {
      if (walked.has(next)) continue;
      const across = this.#across(vertex, next);
      const onward = this.#walk(vertex, next);
      const isClosed = onward.at(-1) === vertex;
      const back = across === undefined || isClosed ? [] : this.#walk(vertex, across);
      lines.push(isClosed ? onward : [...back.reverse(), vertex, ...onward]);
      if (across !== undefined) walked.add(across);
    }
    return lines;
  }

  /** From a vertex by way of the next until the line ends or is back where it began; without the first. */
  #walk(from: number, next: number): number[] {
    const line = [next];
    const last = this.#across(from, next);
    let [before, at] = [from, next];
    for (;;) {
      const after = at === from && before === last ? undefined : this.#across(at, before);
      if (after === undefined) return line;
      line.push(after);
      [before, at] = [at, after];
    }
  }

  /** Straight across a vertex: the neighbour that alone shares no face with the one it is come from, and the other way
   *  round. */
  #across(vertex: number, from: number): number | undefined {
    const across = this.#alone(vertex, from);
    return across !== undefined && this.#alone(vertex, across) === from ? across : undefined;
  }

  #alone(vertex: number, from: number): number | undefined {
    const beside = new Set(this.#cornersAt(vertex).flatMap((corner) => (corner.includes(from) ? corner : [])));
    const others = this.#neighbours(vertex).filter((each) => !beside.has(each));
    return others.length === 1 ? others[0] : undefined;
  }

  #neighbours(vertex: number): number[] {
    return [...new Set(this.#cornersAt(vertex).flat())];
  }

  /** An edge of the boundary has one face only. */
  #boundaryNeighbours(vertex: number): number[] {
    const beside = this.#cornersAt(vertex).flat();
    return beside.filter((each) => beside.indexOf(each) === beside.lastIndexOf(each));
  }

  #cornersAt(vertex: number): readonly Corner[] {
    return this.#corners.get(vertex) ?? [];
  }
}
