// Plays every hard scene with all its seeds and prints its figures as JSON.
import { hardScenes } from '../../scenes/hard'
import { hardRows } from '../stability/play'

console.log(JSON.stringify(hardScenes.flatMap((scene) => hardRows(scene))))
