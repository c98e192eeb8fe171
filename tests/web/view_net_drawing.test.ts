/** What is drawn of a net, as objects of the scene: no picture is made of them. */
import { InstancedMesh, Matrix4, Vector3 } from 'three';
import { expect, test, vi } from 'vitest';
import type { UpAxis } from '../../web/src/document/document';
import { Curve } from '../../web/src/handles/curve';
import { Snapping } from '../../web/src/handles/snapping';
import type { NetData } from '../../web/src/view/net_data';
import { NetDrawing } from '../../web/src/view/net_drawing';
import type { Theme } from '../../web/src/view/theme';
import { describe as describeNet } from '../../web/src/worker/opened_net';
import { load } from '../wasm/load';

const net = describeNet((await load()).openRecipe('dome:vertices=100'));
/** All of one colour. */
const theme = new Proxy({} as Theme, {
  get: (_, name) =>
    name === 'axes'
      ? [
          [0, 0, 0],
          [0, 0, 0],
          [0, 0, 0],
        ]
      : name === 'dark'
        ? false
        : [0, 0, 0],
});
const look = (upAxis: UpAxis) => ({ field: 'deviation', colourMap: 'paper', showFaces: false, upAxis }) as const;

const rounded = (place: Vector3) => place.toArray().map((x) => x.toFixed(5));

test('the curve to which drags keep lies as the net does, whichever axis is up', async () => {
  const drawing = new NetDrawing(theme, look('z'), {
    changed: () => {},
    failed: (error) => expect.fail(String(error)),
  });
  /** Where the curve is drawn, in the scene; it has one piece. */
  const drawn = () => {
    const curves = drawing.object.children.filter((each) => each instanceof InstancedMesh);
    expect(curves).toHaveLength(1);
    const place = new Matrix4();
    curves[0]!.getMatrixAt(0, place);
    return rounded(new Vector3().setFromMatrixPosition(place));
  };
  const middle = ({ space }: NetData) => {
    const place = new Vector3();
    space.toScene(place, [0, 2, 1]);
    return rounded(place);
  };
  const flat = drawing.setNet(net);
  const curve = new Curve([
    [
      [0, 0, 0],
      [0, 4, 2],
    ],
  ]);
  drawing.setSnapping(new Snapping(null, false, 1, curve));
  await vi.waitFor(() => expect(drawn()).toEqual(middle(flat)));
  drawing.setAppearance(look('y'));
  const turned = drawing.setNet(net);
  expect(middle(turned)).not.toEqual(middle(flat));
  await vi.waitFor(() => expect(drawn()).toEqual(middle(turned)));
  drawing.setSnapping(null);
  await vi.waitFor(() => expect(drawing.object.children.some((each) => each instanceof InstancedMesh)).toBe(false));
});
