// Prints the bytes that a step of 60 chips awake allocates, each number the mean of 600 steps. Run by
// world.test.ts in a process of its own, where nothing else has shaped the compiled code.
import { Session } from 'node:inspector/promises'
import { pourChips } from '../../../scenes/piles'
import { frame } from '../../../scenes/scene'
import { run, worldOf } from './worlds'

async function sample() {
  const { world } = worldOf(pourChips('pills', 60, 1), { sleep: false })
  run(world, 20)
  const session = new Session()
  session.connect()
  await session.post('HeapProfiler.enable')
  const rounds: number[] = []
  for (let round = 0; round < 4; round++) {
    const options = {
      samplingInterval: 128,
      includeObjectsCollectedByMajorGC: true,
      includeObjectsCollectedByMinorGC: true,
    }
    await session.post('HeapProfiler.startSampling', options)
    for (let k = 0; k < 600; k++) world.step(frame)
    const { profile } = await session.post('HeapProfiler.stopSampling')
    type Node = (typeof profile)['head']
    const bytes = (node: Node): number =>
      node.selfSize + node.children.reduce((sum, child) => sum + bytes(child), 0)
    rounds.push(bytes(profile.head) / 600)
  }
  console.log(JSON.stringify(rounds))
}

sample()
