#!/bin/sh
# Run by ./gradlew before the wrapper. Refuses a Java that the pinned Gradle does not run on. Where that Gradle is not
# installed yet and Gradle's own site does not answer, lays it out of Maven artifacts, once, where the wrapper looks for it
# (see GradleFromMaven.java).
# Usage: install.sh PROJECT_DIR   Needs, in that case only: a JDK 17 or later (GRADLE_BOOTSTRAP_JAVA or java) and mvn.
set -eu
project=$1
java=${GRADLE_BOOTSTRAP_JAVA:-java}
archive=$(sed -n 's/^distributionUrl=.*\///p' "$project/gradle/wrapper/gradle-wrapper.properties")   # gradle-8.8-bin.zip

# Gradle 8.8 runs on Java 22 at most (Gradle, compatibility matrix), and what is built needs 17.
home=$(command -v "$java") && home=$(readlink -f "$home") && home=${home%/bin/java}
version=$(sed -n 's/^JAVA_VERSION="\([0-9]*\).*/\1/p' "$home/release" 2>/dev/null) || version=
[ -n "$version" ] || version=$("$java" -version 2>&1 | sed -n 's/.*version "\([0-9]*\).*/\1/p' | head -n 1)
case $version in
    1[789] | 2[012] | '') ;;
    *)
        echo "This build needs a JDK from 17 to 22, and $home is Java $version: set JAVA_HOME to a JDK 17 or 21." >&2
        exit 1 ;;
esac

for marker in "${GRADLE_USER_HOME:-$HOME/.gradle}/wrapper/dists/${archive%.zip}"/*/"$archive.ok"; do
    [ -f "$marker" ] && exit 0
done
exec "$java" "$project/gradle/bootstrap/GradleFromMaven.java" "$project"
