#!/bin/sh
# Run by ./gradlew before the wrapper. Where the pinned Gradle is not installed yet and Gradle's own site does not answer,
# lays it out of Maven artifacts, once, where the wrapper looks for it (see GradleFromMaven.java).
# Usage: install.sh PROJECT_DIR   Needs, in that case only: a JDK 17 or later (GRADLE_BOOTSTRAP_JAVA or java) and mvn.
set -eu
project=$1
archive=$(sed -n 's/^distributionUrl=.*\///p' "$project/gradle/wrapper/gradle-wrapper.properties")   # gradle-8.8-bin.zip
for marker in "${GRADLE_USER_HOME:-$HOME/.gradle}/wrapper/dists/${archive%.zip}"/*/"$archive.ok"; do
    [ -f "$marker" ] && exit 0
done
exec "${GRADLE_BOOTSTRAP_JAVA:-java}" "$project/gradle/bootstrap/GradleFromMaven.java" "$project"
