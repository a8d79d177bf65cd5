import 'server-only'
import { componentBytes } from '@/bench/publish/bytes'

/** kB, as the benchmark weighs the component. Measured when the site is built. */
export const componentSize = async () => ((await componentBytes()) / 1000).toFixed(1)
