import type { FormatInfo, InitialisationInfo, MethodInfo, OptionInfo, ShapeInfo } from '../../../wasm/chebnet';

/** What the core can do. */
export interface Tables {
  shapes: ShapeInfo[];
  methods: MethodInfo[];
  initialisations: InitialisationInfo[];
  formats: FormatInfo[];
  options: OptionInfo[];
}
