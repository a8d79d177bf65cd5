import { expect, it } from 'vitest'
import { standing } from './standing'

const stage = { width: 640, height: 340 }
const pill = { width: 80, height: 30, radius: 15 }
const card = { width: 80, height: 30 }
const onFloor = (halfHeight: number, angle: number) => ({ x: 320, y: 340 - halfHeight, angle })
const quarter = Math.PI / 2

it('a pill on its round end and a card on its corner stand on one point', () => {
  expect(standing([pill], [onFloor(40, quarter)], stage)).toBe(1)
  const diagonal = Math.atan2(15, 40)
  expect(standing([card], [onFloor(Math.hypot(40, 15), quarter - diagonal)], stage)).toBe(1)
})

it('who lies, stands on a side, leans on a neighbour or is round does not', () => {
  expect(standing([pill], [onFloor(15, 0)], stage)).toBe(0)
  expect(standing([card], [onFloor(40, quarter)], stage)).toBe(0)
  const disc = { width: 30, height: 30, radius: 15 }
  expect(standing([disc], [onFloor(15, 1)], stage)).toBe(0)
  const leans = [onFloor(40, quarter), { x: 320 + 30, y: 340 - 40, angle: quarter }]
  expect(standing([pill, pill], leans, stage)).toBe(0)
})

it('a pill upright on another pill stands, the one below lies', () => {
  expect(standing([pill, pill], [onFloor(15, 0), onFloor(30 + 40, quarter)], stage)).toBe(1)
})

it('a card that lies balanced on a disc does not stand', () => {
  const disc = { width: 30, height: 30, radius: 15 }
  expect(standing([disc, card], [onFloor(15, 0), onFloor(30 + 15, 0)], stage)).toBe(0)
})
