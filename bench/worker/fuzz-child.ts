// Plays the first block of random scenes and every one that once went wrong; prints what failed as JSON.
import { foundScenes } from '../../scenes/fuzzed'
import { playFuzz } from '../fuzz/play'
import { survey } from '../fuzz/search'

const failing = foundScenes.filter(({ scene, check }) => playFuzz(scene, check)).map(({ name }) => name)
console.log(JSON.stringify({ ...survey(1, 0), failing }))
