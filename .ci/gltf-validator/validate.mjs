// Runs the Khronos glTF validator over the given files: node validate.mjs FILE.glb ...
// Prints one line for each file, then its messages; fails on any error or warning, and on no files at all.

import { readFile } from 'node:fs/promises';
import { basename, dirname, join } from 'node:path';
import validator from 'gltf-validator';

const SEVERITIES = ['error', 'warning', 'info', 'hint'];

async function validate(path) {
  const report = await validator.validateBytes(new Uint8Array(await readFile(path)), {
    uri: basename(path),
    externalResourceFunction: async (uri) =>
      new Uint8Array(await readFile(join(dirname(path), decodeURIComponent(uri)))),
    maxIssues: 0,
  });
  const { numErrors, numWarnings, numInfos, numHints, messages } = report.issues;
  const { totalVertexCount, totalTriangleCount, maxInfluences, animationCount } = report.info;
  console.log(
    `${path}: ${numErrors} errors, ${numWarnings} warnings, ${numInfos} infos, ${numHints} hints ` +
      `(${totalVertexCount} vertices, ${totalTriangleCount} triangles, ${maxInfluences} influences, ` +
      `${animationCount} animations)`,
  );
  const seen = new Map();
  for (const { code, severity, message, pointer } of messages) {
    const earlier = seen.get(code) ?? 0;
    seen.set(code, earlier + 1);
    if (earlier < 5) {
      console.log(`  ${SEVERITIES[severity]} ${code} at ${pointer ?? 'the file'}: ${message}`);
    }
  }
  for (const [code, count] of seen) {
    if (count > 5) {
      console.log(`  ${code}: ${count} in all`);
    }
  }
  return numErrors + numWarnings === 0;
}

const paths = process.argv.slice(2);
if (paths.length === 0) {
  console.error('usage: node validate.mjs FILE.glb ...');
  process.exit(2);
}
let passed = true;
for (const path of paths) {
  try {
    passed = (await validate(path)) && passed;
  } catch (error) {
    console.error(`${path}: ${error.message ?? error}`);
    passed = false;
  }
}
process.exit(passed ? 0 : 1);
