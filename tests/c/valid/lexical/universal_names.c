/* Universal character names, in identifiers and in strings (C17 6.4.3). */
#include <stdio.h>
#include <string.h>

static int gr\u00fc\u00dfe = 5;
static int \u0394x = 7;

int main(void)
{
    const char *text = "\u00e9 \u20ac \U0001f916";

    gr\u00fc\u00dfe += \u0394x;
    printf("%d %u %s\n", gr\u00fc\u00dfe, (unsigned) strlen(text), text);
    printf("%d %d\n", (int) L'\u20ac', (int) sizeof u8"\u00e9");
    return 0;
}
