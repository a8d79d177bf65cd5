// Measures everything the gate holds and prints it as JSON.
import { scenes } from '../../scenes'
import { measureScene } from '../accuracy/regression'

console.log(JSON.stringify(Object.fromEntries(scenes.map((scene) => [scene.name, measureScene(scene)]))))
