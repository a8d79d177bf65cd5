// Measures everything the gate holds and prints it as JSON.
import { gated } from './gate'

const measured = Object.fromEntries(gated.map(({ name, measure }) => [name, measure()]))
console.log(JSON.stringify(measured))
