/** Classes of tinted chips, taken in turn: on the home page's stage, and in the code beside it. */
export const tints = ['bg-red-400', 'bg-amber-300', 'bg-sky-400', 'bg-emerald-300', 'bg-purple-300']
