/* More than there is, in a size that would wrap around. */
int main(int argc, char **argv)
{
    unsigned n = 65536 * argc;
    int grid[n][n]; // error: no memory for local array
    grid[0][0] = 1;
    return 0;
}
