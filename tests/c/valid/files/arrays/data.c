int table[] = {1, 2, 3, 4, 5};
const char *const names[] = {"one", "two", "three"};
int limit = 7;
extern int grid[][3];
int total(void)
{
    int i, sum = 0;
    for (i = 0; i < 6; i++)
        sum += grid[i / 3][i % 3];
    return sum + table[0];
}
