/* No element at all, in the second dimension. */
int main(int argc, char **argv)
{
    double grid[4][argc - 1]; // error: non-positive array length
    return sizeof grid;
}
