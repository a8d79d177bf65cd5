/** @type {import('next').NextConfig} */
export default {
  output: 'export',
  reactStrictMode: true,
  // The registry's and benchmark's tooling lives in this tree too; only this folder is the site's root.
  turbopack: { root: import.meta.dirname },
}
