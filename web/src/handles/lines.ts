/** Lines of vertices that a net is made of: its boundary loops and its net lines. */

export interface Faces {
  /** Face f is `faceVertices[faceStart[f]] … faceVertices[faceStart[f + 1] - 1]`. */
  faceStart: Int32Array;
  faceVertices: Int32Array;
}

export class Lines {
  /** The corners at vertex v are those from `#start[v]` to `#start[v + 1]`: two neighbours each that share a face with it. */
  readonly #start: Int32Array;
  readonly #corners: Int32Array;

  constructor({ faceStart, faceVertices }: Faces) {
    const count = faceVertices.reduce((most, vertex) => Math.max(most, vertex + 1), 0);
    this.#start = new Int32Array(count + 1);
    for (const vertex of faceVertices) this.#start[vertex + 1]! += 1;
    for (let vertex = 0; vertex < count; ++vertex) this.#start[vertex + 1]! += this.#start[vertex]!;
    this.#corners = new Int32Array(2 * faceVertices.length);
    const next = this.#start.slice();
    for (let face = 0; face + 1 < faceStart.length; ++face) {
      const [first, end] = [faceStart[face]!, faceStart[face + 1]!];
      for (let corner = first; corner < end; ++corner) {
        const slot = next[faceVertices[corner]!]!++;
        this.#corners[2 * slot] = faceVertices[corner === first ? end - 1 : corner - 1]!;
        this.#corners[2 * slot + 1] = faceVertices[corner + 1 === end ? first : corner + 1]!;
      }
    }
  }

  isBoundary(vertex: number): boolean {
    return this.#boundaryNeighbours(vertex).length > 0;
  }

  /** The boundary loop through a vertex, which comes first; empty if it lies inside. */
  boundary(vertex: number): number[] {
    const loop = new Set<number>();
    let next = this.isBoundary(vertex) ? vertex : undefined;
    while (next !== undefined) {
      loop.add(next);
      next = this.#boundaryNeighbours(next).find((each) => !loop.has(each));
    }
    return [...loop];
  }

  /** The net lines through a vertex, each from end to end; a closed one begins anywhere. A line goes straight on: a regular
   *  vertex has two of them; a singular one, where lines end, has one for each of its edges. */
  through(vertex: number): number[][] {
    return this.#directions(vertex).map(([next, across]) => this.#line(vertex, next, across));
  }

  /** All net lines, each once, from end to end; a closed one ends with the vertex it begins with. */
  all(): number[][] {
    const lines: number[][] = [];
    const walked = new Set<string>();
    for (let vertex = 0; vertex + 1 < this.#start.length; ++vertex) {
      for (const [next, across] of this.#directions(vertex)) {
        if (walked.has(edgeName(vertex, next))) continue;
        const line = this.#line(vertex, next, across);
        if (line.at(-1) === vertex) line.unshift(vertex);
        for (let k = 1; k < line.length; ++k) walked.add(edgeName(line[k - 1]!, line[k]!));
        lines.push(line);
      }
    }
    return lines;
  }

  #line(vertex: number, next: number, across: number | undefined): number[] {
    const onward = this.#walk(vertex, next);
    if (onward.at(-1) === vertex) return onward;
    const back = across === undefined ? [] : this.#walk(vertex, across);
    return [...back.reverse(), vertex, ...onward];
  }

  /** How many of them there are. */
  count(vertex: number): number {
    return this.#directions(vertex).length;
  }

  /** Each as the neighbour it goes to and the one it comes from, if it comes through. */
  #directions(vertex: number): [number, number | undefined][] {
    const neighbours = this.#neighbours(vertex);
    const pairs = neighbours.map((next): [number, number | undefined] => [next, this.#across(vertex, next)]);
    return pairs.filter(([next, across]) => across === undefined || neighbours.indexOf(next) < neighbours.indexOf(across));
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
    const around = this.#around(vertex);
    const beside = new Set(around.flatMap((each, i) => (each === from ? [from, around[i ^ 1]!] : [])));
    const others = this.#neighbours(vertex).filter((each) => !beside.has(each));
    return others.length === 1 ? others[0] : undefined;
  }

  #neighbours(vertex: number): number[] {
    return [...new Set(this.#around(vertex))];
  }

  /** An edge of the boundary has one face only. */
  #boundaryNeighbours(vertex: number): number[] {
    const around = this.#around(vertex);
    return around.filter((each) => around.indexOf(each) === around.lastIndexOf(each));
  }

  /** Its neighbours, corner by corner. */
  #around(vertex: number): number[] {
    return Array.from(this.#corners.subarray(2 * this.#start[vertex]!, 2 * this.#start[vertex + 1]!));
  }
}

function edgeName(a: number, b: number): string {
  return a < b ? `${a} ${b}` : `${b} ${a}`;
}
