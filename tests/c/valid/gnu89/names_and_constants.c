/* Later keywords as names, and constants that C90 makes unsigned. */
// gcc options: -std=gnu89
#include <stdio.h>
int restrict = 4;
int f(int inline_, int restrict) {
    return inline_ + restrict;
}

int bool = 3, nullptr = 2, alignas = 1, static_assert = 9, constexpr = 8, thread_local = 7,
    true = 6, false = 5;
int main() {
    printf("%d\n", -2147483648 < 0);
    printf("%d\n", 2147483648 > -1);
    printf("%d\n", (int)sizeof(2147483648));
    printf("%d %d\n", f(1,2), restrict);
    printf("%d\n", -1 < 2147483648);
    printf("%d\n", bool+nullptr+alignas+static_assert+constexpr+thread_local+true+false);
    return 0  //* no */ 1
    ;
}
