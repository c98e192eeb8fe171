/** The text of a recipe, as core/shapes/shapes.h has it: NAME or NAME:key=value,key=value … */
import type { ShapeInfo, ShapeParameter } from '../../../wasm/chebnet';

export interface Recipe {
  name: string;
  values: Record<string, number>;
}

export function parseRecipe(text: string): Recipe {
  const [name = '', list = ''] = text.split(':');
  const values: Record<string, number> = {};
  for (const item of list.split(',')) {
    const [key = '', value = ''] = item.split('=').map((part) => part.trim());
    if (key) values[key] = Number(value);
  }
  return { name: name.trim(), values };
}

/** Leaves out what has its default, so that links stay short. */
export function formatRecipe({ name, values }: Recipe, shape: ShapeInfo): string {
  const given = shape.parameters.flatMap((parameter) => {
    const value = values[parameter.name];
    return value === undefined || value === parameter.value ? [] : [`${parameter.name}=${value}`];
  });
  return given.length > 0 ? `${name}:${given.join(',')}` : name;
}

/** How a slider of 0 … `SLIDER_STEPS` stands for a parameter. Whole numbers stay whole; ranges over three decades, as that of
 *  the number of vertices, are logarithmic. */
export const SLIDER_STEPS = 200;

export function toSlider(parameter: ShapeParameter, value: number): number {
  const { smallest, largest } = parameter;
  const share = isLogarithmic(parameter)
    ? Math.log(value / smallest) / Math.log(largest / smallest)
    : (value - smallest) / (largest - smallest);
  return Math.round(share * SLIDER_STEPS);
}

export function fromSlider(parameter: ShapeParameter, at: number): number {
  const { smallest, largest } = parameter;
  const share = at / SLIDER_STEPS;
  const value = isLogarithmic(parameter)
    ? smallest * (largest / smallest) ** share
    : smallest + share * (largest - smallest);
  const rounded = isWhole(parameter) ? Math.round(Number(value.toPrecision(2))) : Number(value.toPrecision(3));
  return Math.min(largest, Math.max(smallest, rounded));
}

/** Whether a parameter is a whole number: its default and its range are. */
function isWhole({ value, smallest, largest }: ShapeParameter): boolean {
  return [value, smallest, largest].every(Number.isInteger) && largest - smallest > 2;
}

function isLogarithmic({ smallest, largest }: ShapeParameter): boolean {
  return smallest > 0 && largest / smallest >= 1000;
}
