// Next runs this before it starts the page. React is set up here, in a task of its own: the loader of
// scripts/late-scripts.mjs lets Next go on in another one, so that a slow phone can answer in between.
import 'react-dom/client'
