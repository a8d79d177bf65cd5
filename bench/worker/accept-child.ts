// Plays subjects of `npm run accept`: takes a subject and its seeds a line, prints their runs as JSON.
import { createInterface } from 'node:readline'
import { groups } from '../accept/groups'
import type { Run } from '../accept/row'

const subjects = new Map(groups.flatMap(({ subjects }) => subjects.map((one) => [one.name, one])))

for await (const line of createInterface({ input: process.stdin })) {
  const { name, seeds }: { name: string; seeds: number[] } = JSON.parse(line)
  const runs: Run[] = []
  for (const seed of seeds) runs.push(await subjects.get(name)!.play(seed))
  console.log(JSON.stringify(runs))
}
